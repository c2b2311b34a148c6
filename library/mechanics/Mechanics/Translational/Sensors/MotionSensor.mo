within Mechanics.Translational.Sensors;
model MotionSensor "Position and speed of a rod"
  extends Interfaces.PartialOneFlange;
  output Units.Position s "Absolute position";
  output Units.Velocity v "Absolute velocity";
equation
  // A sensor takes no force
  flange.f = 0;
  // Motion
  s = flange.s;
  v = der(s);
  annotation(Documentation(info = "<html>
<p>s and its derivative.</p>
</html>"));
end MotionSensor;
