within TenSpeed.Benches;
model SwitchValveL3 "Switch valve at level 3: pilot pressure up and down"
  extends Interfaces.SwitchBench(redeclare model Valve = Valves.Levels.SwitchValveL3,
    inflow = valve.m_supply + valve.m_pilot);
  annotation(
    experiment(StopTime = 4.8, Tolerance = 1e-6, Interval = 1e-3),
    Documentation(info = "<html>
<p>2 states.</p>
</html>"));
end SwitchValveL3;
