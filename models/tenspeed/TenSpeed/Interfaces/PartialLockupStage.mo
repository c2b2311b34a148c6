within TenSpeed.Interfaces;
partial model PartialLockupStage "Level of the lock-up control valve"
  extends PartialRegulatorStage;
  Hydraulics.Interfaces.Port supply "Supply";
  Hydraulics.Interfaces.Port drain "Drain";
  Hydraulics.Interfaces.Port outlet "Lock-up clutch";
  Hydraulics.Interfaces.Port command "Pressure of the lock-up solenoid";
  annotation(Documentation(info = "<html>
<p>Ports of every level.</p>
</html>"));
end PartialLockupStage;
