within Mechanics.Rotational.Sensors;
model MotionSensor "Angle and speed of a shaft"
  extends Interfaces.PartialSensor;
  output Units.Angle phi "Absolute angle";
  output Units.AngularVelocity w "Absolute angular velocity";
equation
  // Motion
  phi = flange.phi;
  w = der(phi);
  annotation(Documentation(info = "<html>
<p>phi and its derivative.</p>
</html>"));
end MotionSensor;
