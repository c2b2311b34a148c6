within TenSpeed.Interfaces;
partial model TwoWayClutchBench "Two-way-clutch valve alone, its pressures prescribed"
  replaceable package Oil = Hydraulics.Media.OilDexronVI constrainedby Hydraulics.Media.PartialOil
    "Oil whose data are the default" annotation(choicesAllMatching = true);
  parameter Hydraulics.Media.Fluid fluid = Oil.data "Oil of valve and loads";
  replaceable model Valve = Valves.TwoWayClutchValve constrainedby Valves.TwoWayClutchValve "Valve under test"
    annotation(choicesAllMatching = true);
  Valve valve(final fluid = fluid) "Valve under test";
  Signals.Sources.SmoothSteps drive(
    times = {0.1, 3.1},
    values = {101325, 3.5e5, 101325},
    duration = 2.9) "Pressure to drive: slowly up and down";
  Signals.Sources.SmoothSteps reverse(
    times = {6.1, 9.1},
    values = {101325, 3.5e5, 101325},
    duration = 2.9) "Pressure to reverse: slowly up and down";
  Hydraulics.Sources.PressureSignal toDrive[2] "Solenoids that push to drive";
  Hydraulics.Sources.PressureSignal toReverse[2] "Solenoids that push to reverse";
  output Hydraulics.Units.AbsolutePressure p_drive = drive.y "Pressure to drive";
  output Hydraulics.Units.AbsolutePressure p_reverse = reverse.y "Pressure to reverse";
  output Mechanics.Units.Position s = valve.s "Position: 0 in reverse, stroke in drive";
  output Hydraulics.Units.MassFlowRate inflow = valve.m_in "Mass flow into the valve";
  output Hydraulics.Units.MassFlowRate outflow = 0 "Nothing flows out elsewhere";
  output Mechanics.Units.Mass m_oil = valve.m_oil "Mass of oil and air in the valve";
equation
  for k in 1:2 loop
    connect(drive.y, toDrive[k].p);
    connect(reverse.y, toReverse[k].p);
    connect(toDrive[k].port, valve.drive[k]);
    connect(toReverse[k].port, valve.reverse[k]);
  end for;
  annotation(Documentation(info = "<html>
<p>inflow = d m_oil/dt. Both pressures of a side are equal here.</p>
</html>"));
end TwoWayClutchBench;
