within TenSpeed.Benches;
model MainRegulatorPressureL4 "Main regulator at level 4: flow taken from a prescribed line pressure"
  extends Interfaces.MainRegulatorBench(
    redeclare model Valve = Valves.Levels.MainRegulatorL4,
    redeclare replaceable Hydraulics.Sources.PressureSource supply(
      p_start = 8e5,
      p_end = 10.3e5,
      startTime = 0.5,
      duration = 2) constrainedby Hydraulics.Interfaces.PartialSource);
  annotation(
    experiment(StopTime = 3.5, Tolerance = 1e-6, Interval = 1e-3),
    Documentation(info = "<html>
<p>3 states.</p>
</html>"));
end MainRegulatorPressureL4;
