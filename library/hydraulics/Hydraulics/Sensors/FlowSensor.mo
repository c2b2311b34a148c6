within Hydraulics.Sensors;
model FlowSensor "Volume flow through a line"
  Interfaces.Port port_a "Where the flow comes from when it is positive";
  Interfaces.Port port_b "Where it goes to";
  Signals.Interfaces.RealOutput q(unit = "m3/s") "Volume flow at the density of the line";
equation
  // One pressure on both sides
  port_a.p = port_b.p;
  port_a.q + port_b.q = 0;
  q = port_a.q;
  annotation(Documentation(info = "<html>
<p>q from port_a to port_b. Both ports have one pressure, hence one density.</p>
</html>"));
end FlowSensor;
