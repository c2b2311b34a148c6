within Hydraulics.Interfaces;
partial model PartialSensor "Sensor at one port"
  Port port "Port";
equation
  // A sensor takes no oil
  port.q = 0;
  annotation(Documentation(info = "<html>
<p>q = 0. The extending model says what is measured.</p>
</html>"));
end PartialSensor;
