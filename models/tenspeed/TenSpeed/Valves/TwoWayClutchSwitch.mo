within TenSpeed.Valves;
partial model TwoWayClutchSwitch "Net force of the pressures, and the position that the detents let it choose"
  extends Interfaces.PartialTwoWayClutchStage;
  final parameter Mechanics.Units.Force rise = c_detent*hump/2 "Of a detent's force half-way up";
  final parameter Mechanics.Units.Ratio steepest = ((F_detent + rise) - sqrt((F_detent + rise)^2 + 8*rise^2))/(4*rise)
    "Cosine of the cam's phase at which the detents' force is largest";
  parameter Mechanics.Units.Force F_pass = 2*Hydraulics.Constants.pi*hump/stroke*sqrt(1 - steepest^2)*
    (F_detent + rise*(1 - steepest)) "Force that passes both detents; largest force of the rigid cam";
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
