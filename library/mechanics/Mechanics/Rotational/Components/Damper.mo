within Mechanics.Rotational.Components;
model Damper "Linear torsional damper"
  extends Interfaces.PartialCompliantWithSpeed;
  parameter Units.RotationalDampingConstant d "Damping";
  Units.Power lossPower "Power turned into heat";
equation
  // Viscous friction
  tau = d*w_rel;
  // Energy
  lossPower = tau*w_rel;
  annotation(Documentation(info = "<html>
<p>tau = d w_rel.</p>
</html>"));
end Damper;
