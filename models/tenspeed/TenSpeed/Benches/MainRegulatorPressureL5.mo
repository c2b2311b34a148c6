within TenSpeed.Benches;
model MainRegulatorPressureL5 "Main regulator at level 5: flow taken from a prescribed line pressure"
  extends Interfaces.MainRegulatorBench(
    redeclare model Valve = Valves.Levels.MainRegulatorL5,
    redeclare replaceable Hydraulics.Sources.PressureSource supply(
      p_start = 8e5,
      p_end = 10.3e5,
      startTime = 0.5,
      duration = 2) constrainedby Hydraulics.Interfaces.PartialSource);
  annotation(
    experiment(StopTime = 3.5, Tolerance = 1e-6, Interval = 1e-3),
    Documentation(info = "<html>
<p>No state.</p>
</html>"));
end MainRegulatorPressureL5;
