within Hydraulics.Sources;
model FlowSignal "Volume flow prescribed by a signal"
  extends Interfaces.PartialSource;
  Signals.Interfaces.RealInput q(unit = "m3/s") "Flow out of the source";
equation
  port.q = -q;
  annotation(Documentation(info = "<html>
<p>The flow of the signal enters the circuit, whatever the pressure.</p>
</html>"));
end FlowSignal;
