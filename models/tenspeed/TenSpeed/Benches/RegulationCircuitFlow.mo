within TenSpeed.Benches;
model RegulationCircuitFlow "Regulation circuit fed by a flow, every valve at level 1"
  extends Interfaces.RegulationCircuit;
  annotation(
    experiment(StopTime = 2.5, Tolerance = 1e-6, Interval = 1e-3),
    Documentation(info = "<html>
<p>17 states.</p>
</html>"));
end RegulationCircuitFlow;
