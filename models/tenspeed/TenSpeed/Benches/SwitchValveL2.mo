within TenSpeed.Benches;
model SwitchValveL2 "Switch valve at level 2: pilot pressure up and down"
  extends Interfaces.SwitchBench(redeclare model Valve = Valves.Levels.SwitchValveL2,
    inflow = valve.m_supply + valve.m_pilot);
  annotation(
    experiment(StopTime = 4.8, Tolerance = 1e-6, Interval = 1e-3),
    Documentation(info = "<html>
<p>3 states.</p>
</html>"));
end SwitchValveL2;
