within Hydraulics.Sources;
model PressureSignal "Pressure prescribed by a signal"
  extends Interfaces.PartialSource;
  Signals.Interfaces.RealInput p(unit = "Pa") "Absolute pressure";
equation
  port.p = p;
  annotation(Documentation(info = "<html>
<p>The port has the pressure of the signal, whatever the flow. Connected to a volume without a restriction between,
the signal must be differentiable.</p>
</html>"));
end PressureSignal;
