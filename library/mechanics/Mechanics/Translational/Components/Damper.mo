within Mechanics.Translational.Components;
model Damper "Linear damper"
  extends Interfaces.PartialCompliantWithSpeed;
  parameter Units.TranslationalDampingConstant d "Damping";
  Units.Power lossPower "Power turned into heat";
equation
  // Viscous friction
  f = d*v_rel;
  // Energy
  lossPower = f*v_rel;
  annotation(Documentation(info = "<html>
<p>f = d v_rel.</p>
</html>"));
end Damper;
