within Mechanics.Rotational.Components;
model ElasticPlanetary "Simple planetary gearset with elasticity, damping and backlash lumped at the sun"
  parameter Units.Ratio ratio "Number of ring teeth over number of sun teeth";
  parameter Units.RotationalSpringConstant c "Stiffness seen at the sun with carrier and ring held";
  parameter Units.RotationalDampingConstant d = 0 "Damping seen at the sun";
  parameter Units.Angle b(min = 0) = 0 "Play seen at the sun";
  Interfaces.Flange sun "Sun shaft";
  Interfaces.Flange carrier "Carrier shaft";
  Interfaces.Flange ring "Ring shaft";
  ElasticBacklash elasticity(c = c, d = d, b = b) "Meshes and bearings, as seen at the sun";
  IdealPlanetary gearset(ratio = ratio) "Kinematics";
equation
  connect(sun, elasticity.flange_a);
  connect(elasticity.flange_b, gearset.sun);
  connect(carrier, gearset.carrier);
  connect(ring, gearset.ring);
  annotation(Documentation(info = "<html>
<p>The ideal gearset behind an elastic coupling with play at its sun. It adds no constraint between the three shafts and
no state. Measure c and b of a gearset with individual planets by a slow torque on its sun with carrier and ring
held.</p>
</html>"));
end ElasticPlanetary;
