within TenSpeed.Interfaces;
partial model PartialReliefStage "Level of a regulator that drains what is too much"
  extends PartialRegulatorStage;
  Hydraulics.Interfaces.Port inlet "Line, whose pressure the valve regulates";
  Hydraulics.Interfaces.Port drain "Outlet for what is too much";
  annotation(Documentation(info = "<html>
<p>Ports of every level.</p>
</html>"));
end PartialReliefStage;
