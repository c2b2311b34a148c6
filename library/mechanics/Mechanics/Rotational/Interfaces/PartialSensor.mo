within Mechanics.Rotational.Interfaces;
partial model PartialSensor "Sensor at one shaft"
  extends PartialOneFlange;
equation
  // A sensor takes no torque
  flange.tau = 0;
  annotation(Documentation(info = "<html>
<p>tau = 0. The extending model says what is measured.</p>
</html>"));
end PartialSensor;
