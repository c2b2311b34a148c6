within Mechanics.Translational.Components;
model ElasticBacklash "Elastic, damped coupling of two rods with play"
  extends Interfaces.PartialCompliantWithSpeed;
  parameter Units.TranslationalSpringConstant c "Stiffness in contact";
  parameter Units.TranslationalDampingConstant d = 0 "Damping in contact";
  parameter Units.Length b(min = 0) = 0 "Total play";
  Units.Power lossPower "Power turned into heat";
  Units.Energy storedEnergy "Energy of the spring";
equation
  // Contact on one side, on the other, or on none
  f = Functions.backlashForce(s_rel, v_rel, b, c, d);
  // Energy
  lossPower = (f - Functions.backlashForce(s_rel, 0, b, c, 0))*v_rel;
  storedEnergy = Functions.backlashEnergy(s_rel, b, c);
  annotation(Documentation(info = "<html>
<p>f = 0 within the play, c (s_rel &plusmn; b/2) plus damping beyond it, never pulling a contact together. The force is
continuous and makes no event.</p>
</html>"));
end ElasticBacklash;
