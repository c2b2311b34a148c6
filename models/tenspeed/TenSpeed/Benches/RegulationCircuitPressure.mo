within TenSpeed.Benches;
model RegulationCircuitPressure "Regulation circuit at a prescribed line pressure, every valve at level 1"
  extends Interfaces.RegulationCircuit(
    redeclare replaceable Hydraulics.Sources.PressureSource supply(
      p_start = 101325,
      p_end = 10.2e5,
      startTime = 0.1,
      duration = 1.7) constrainedby Hydraulics.Interfaces.PartialSource);
  annotation(
    experiment(StopTime = 2.5, Tolerance = 1e-6, Interval = 1e-3),
    Documentation(info = "<html>
<p>16 states.</p>
</html>"));
end RegulationCircuitPressure;
