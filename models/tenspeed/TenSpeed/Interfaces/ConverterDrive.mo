within TenSpeed.Interfaces;
partial model ConverterDrive "60 s of driving: tip-in, lock, tip-out, engine braking, unlock, overrunning, stop"
  replaceable package Oil = Hydraulics.Media.OilDexronVI constrainedby Hydraulics.Media.PartialOil
    "Oil whose data are the default" annotation(choicesAllMatching = true);
  parameter Hydraulics.Media.Fluid fluid = Oil.data "Oil of the lock-up cylinder";
  replaceable model Torus = Converter.TorusL1 constrainedby Converter.PartialTorus "Level of the circuit"
    annotation(choicesAllMatching = true);
  Converter.TorqueConverter converter(redeclare model Torus = Torus, final fluid = fluid, w_p_start = 80) "Torque converter";
  Converter.Engine engine "Engine";
  Converter.VehicleShaft vehicle "Vehicle in fifth gear";
  Signals.Sources.SmoothSteps torque(
    times = {2, 18, 20, 30, 44, 50, 56},
    values = {0, 150, 0, -30, 140, -40, 0, 60},
    duration = 0.2) "Engine torque: tip-in at 2, 30 and 56 s, tip-out at 18 and 44 s, engine braking after each";
  Signals.Sources.SmoothSteps pressure(
    times = {12, 25, 36, 47},
    values = {1.1e5, 7e5, 1.1e5, 7e5, 1.1e5},
    duration = 0.5) "Lock-up pressure: lock at 12 and 36 s, unlock at 25 and 47 s";
  Signals.Sources.SmoothSteps brake(times = {50, 55}, values = {0, 900, 0}, duration = 0.5) "Brakes: stop at 50 s";
  Hydraulics.Sources.PressureSignal source "Lock-up supply";
  output Mechanics.Units.AngularVelocity impellerSpeed = engine.w "Speed of the impeller";
  output Mechanics.Units.AngularVelocity turbineSpeed = vehicle.w "Speed of the turbine";
  output Mechanics.Units.Torque impellerTorque = converter.torus.impeller.tau "Torque into the circuit's impeller";
  output Mechanics.Units.Torque turbineTorque = -converter.torus.turbine.tau "Torque out of the circuit's turbine";
  output Mechanics.Units.Torque lockupTorque = converter.lockup.tau "Torque of the lock-up clutch";
  output Boolean locked = converter.lockup.stuck "Whether the lock-up clutch sticks";
equation
  connect(torque.y, engine.tau);
  connect(engine.shaft, converter.impeller);
  connect(converter.turbine, vehicle.shaft);
  connect(brake.y, vehicle.brake);
  connect(pressure.y, source.p);
  connect(source.port, converter.port);
  annotation(Documentation(info = "<html>
<p>From standstill with idling engine: tip-in at 2 s, lock at 12 s, tip-out at 18 s, engine braking with the clutch
locked from 20 s and, after it opens at 25 s, through the circuit; tip-in at 30 s, lock at 36 s, engine braking from
44 s, unlock at 47 s; the brakes stop the vehicle at idle from 50 s; tip-in from standstill at 56 s.</p>
</html>"));
end ConverterDrive;
