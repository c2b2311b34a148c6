within Hydraulics.Sensors;
model PressureSensor "Absolute pressure of a line"
  extends Interfaces.PartialSensor;
  Signals.Interfaces.RealOutput p(unit = "Pa") "Pressure";
equation
  p = port.p;
  annotation(Documentation(info = "<html>
<p>p of the port; subtract <code>Constants.p_atmosphere</code> for a gauge.</p>
</html>"));
end PressureSensor;
