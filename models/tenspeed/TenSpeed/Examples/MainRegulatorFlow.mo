within TenSpeed.Examples;
model MainRegulatorFlow "Main-regulator circuit fed by a constant flow: five states"
  extends Interfaces.MainRegulatorCircuit;
  Hydraulics.Sources.FlowSource supply(
    q_start = 0,
    q_end = 20/60000,
    duration = 0.2) "Pump; chosen: 20 l/min, reached within 0.2 s";
equation
  // Supply
  connect(supply.port, line.port[1]);
  annotation(
    experiment(StopTime = 1, Tolerance = 1e-6),
    Documentation(info = "<html>
<p>The line pressure is a state; the valve regulates it to about 10 bar.</p>
</html>"));
end MainRegulatorFlow;
