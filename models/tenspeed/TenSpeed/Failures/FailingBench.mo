within TenSpeed.Failures;
model FailingBench "Shift sweep with loads that come suddenly; without changes nothing fails"
  extends Interfaces.GearboxBench(redeclare replaceable Gearbox.Level4 gearbox);
  parameter Mechanics.Units.Time t_step = 9 "Instant at which the loads come; chosen: in second gear";
  parameter Mechanics.Units.Torque inputStep = 0 "Added to the input torque";
  parameter Mechanics.Units.Torque outputStep = 0 "Added to the torque on the output shaft, positive drives forward";
  parameter Mechanics.Units.Force holdingForce = 0 "Normal force of a brake that holds the output from the start";
  Mechanics.Rotational.Sources.TorqueSignal inputLoad "Sudden load of the input";
  Mechanics.Rotational.Sources.TorqueSignal outputLoad "Sudden load of the output";
  Mechanics.Rotational.Components.FrictionBrake holding(N_f = 10) "Brake that holds the output";
equation
  connect(inputLoad.flange, gearbox.flange_in);
  connect(outputLoad.flange, gearbox.flange_out);
  connect(holding.flange, gearbox.flange_out);
  inputLoad.tau = if time < t_step then 0 else inputStep;
  outputLoad.tau = if time < t_step then 0 else outputStep;
  holding.f_normal = holdingForce;
  annotation(
    experiment(StopTime = 10, Tolerance = 1e-6, Interval = 1e-2),
    Documentation(info = "<html>
<p>The loads jump: each is an event.</p>
</html>"));
end FailingBench;
