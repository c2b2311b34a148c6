within Hydraulics.Examples;
model SourcesAndSensors "Every source over time, seen by sensors"
  Sources.PressureTable pressureTable(times = {0, 1, 2}, values = {1e5, 3e5, 2e5}) "Table of pressures";
  Sources.FlowTable flowTable(times = {0, 1}, values = {0, 1e-4}) "Table of flows";
  Sources.FilteredPressureStep pressureStep(p_start = 1e5, p_end = 5e5, T = 0.2) "Filtered step of pressure";
  Sources.FilteredFlowStep flowStep(q_end = 1e-4, T = 0.3) "Filtered step of flow";
  Sources.FlowSignal flowSignal "Flow by a signal";
  Sources.PressureSignal pressureSignal "Pressure by a signal";
  Signals.Sources.Constant two(k = 2e5) "Signal";
  Sensors.PressureSensor seenSignal "Sees the pressure by a signal";
  Signals.Sources.Constant half(k = 5e-5) "Signal";
  Sensors.PressureSensor seenTable "Sees the table";
  Sensors.PressureSensor seenStep "Sees the step";
  Sensors.FlowSensor seenFlow "Sees both flows and the signal";
  Sources.Tank tank "Tank";
  Real lag[4](start = {1e5, 1e5, 0, 0}, each fixed = true) "Two lags of first order for each filtered step";
  output Real error(unit = "1") "Sum of the relative differences to table and lags";
equation
  connect(pressureTable.port, seenTable.port);
  connect(pressureStep.port, seenStep.port);
  connect(two.y, pressureSignal.p);
  connect(pressureSignal.port, seenSignal.port);
  connect(half.y, flowSignal.q);
  connect(flowTable.port, seenFlow.port_a);
  connect(flowSignal.port, seenFlow.port_a);
  connect(flowStep.port, seenFlow.port_a);
  connect(seenFlow.port_b, tank.port);
  // The lags whose response the sources give in closed form
  der(lag[1]) = (5e5 - lag[1])/0.2;
  der(lag[2]) = (lag[1] - lag[2])/0.2;
  der(lag[3]) = (1e-4 - lag[3])/0.3;
  der(lag[4]) = (lag[3] - lag[4])/0.3;
  error = (seenTable.p - noEvent(if time < 1 then 1e5 + 2e5*time else 4e5 - 1e5*time))/1e5
    + (seenSignal.p - 2e5)/2e5 + (seenStep.p - lag[2])/4e5 + (seenFlow.q - noEvent(min(time, 1))*1e-4 - 5e-5 - lag[4])/1e-4;
  annotation(
    experiment(StopTime = 2, Tolerance = 1e-8),
    Documentation(info = "<html>
<p>Tables are linear between their points; a filtered step is the response of two equal lags of first order.</p>
</html>"));
end SourcesAndSensors;
