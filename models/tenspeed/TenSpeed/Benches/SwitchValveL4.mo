within TenSpeed.Benches;
model SwitchValveL4 "Switch valve at level 4: pilot pressure up and down"
  extends Interfaces.SwitchBench(redeclare model Valve = Valves.Levels.SwitchValveL4,
    inflow = valve.m_supply + valve.m_pilot);
  annotation(
    experiment(StopTime = 4.8, Tolerance = 1e-6, Interval = 1e-3),
    Documentation(info = "<html>
<p>One state.</p>
</html>"));
end SwitchValveL4;
