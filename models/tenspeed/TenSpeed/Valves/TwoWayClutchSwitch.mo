within TenSpeed.Valves;
partial model TwoWayClutchSwitch "Net force of the pressures, and the position that the detents let it choose"
  extends Interfaces.PartialTwoWayClutchStage;
  parameter Mechanics.Units.Force F_pass = 16.6 "Force that passes the detents; calibrated on TwoWayClutchValveL1";
  Mechanics.Units.Force net "Force of the pressures";
  Boolean toDrive(start = false) "The chosen position is drive";
equation
  // One net force
  net = A*sum(drive[k].p - reverse[k].p for k in 1:2);
  // Detents as hysteresis
  toDrive = net > F_pass or pre(toDrive) and net > -F_pass;
  // Nothing is displaced
  for k in 1:2 loop
    drive[k].q = 0;
    reverse[k].q = 0;
  end for;
  m_oil = 0;
  annotation(Documentation(info = "<html>
<p>Drive from net > F_pass on, reverse from net < -F_pass on, else as before.</p>
</html>"));
end TwoWayClutchSwitch;
