within TenSpeed.Interfaces;
partial model ConverterBench "Test bench of the hydrodynamic circuit: a source at each shaft, characteristic figures"
  replaceable model Torus = Converter.TorusL1 constrainedby Converter.PartialTorus "Level of the circuit"
    annotation(choicesAllMatching = true);
  parameter Converter.Geometry geometry "Circuit under test";
  Torus torus(final geometry = geometry, w_p_start = 200, Q_start = 0.09) "Circuit under test";
  replaceable Converter.Dynamometer impellerSource(w_start = 200) constrainedby Converter.PartialDrive
    "At the impeller";
  replaceable Converter.Dynamometer turbineSource(
    w_start = -0.3,
    w_end = 240,
    startTime = 10,
    duration = 4000) constrainedby Converter.PartialDrive "At the turbine";
  output Mechanics.Units.AngularVelocity impellerSpeed "Speed of the impeller";
  output Mechanics.Units.AngularVelocity turbineSpeed "Speed of the turbine";
  output Mechanics.Units.Torque impellerTorque "Torque into the impeller";
  output Mechanics.Units.Torque turbineTorque "Torque out of the turbine";
  output Mechanics.Units.Ratio speedRatio "Speed of the turbine over that of the impeller";
  output Mechanics.Units.Ratio torqueRatio "Torque out of the turbine over torque into the impeller, 1 without torque";
  output Real capacityFactor "K in rpm/sqrt(N.m): speed of the impeller over the root of its torque";
  output Mechanics.Units.Ratio efficiency "Power out of the turbine over power into the impeller";
protected
  constant Mechanics.Units.Torque tau_small = 1e-3 "Torque that counts as none";
  constant Mechanics.Units.AngularVelocity w_small = 1e-3 "Speed that counts as rest";
equation
  // Only the sources differ
  connect(impellerSource.shaft, torus.impeller);
  connect(turbineSource.shaft, torus.turbine);
  // Observed
  impellerSpeed = torus.impeller.w;
  turbineSpeed = torus.turbine.w;
  impellerTorque = torus.impeller.tau;
  turbineTorque = -torus.turbine.tau;
  speedRatio = noEvent(if abs(impellerSpeed) > w_small then turbineSpeed/impellerSpeed else 0);
  torqueRatio = noEvent(if abs(impellerTorque) > tau_small then turbineTorque/impellerTorque else 1);
  capacityFactor = 30/Mechanics.Constants.pi*impellerSpeed/sqrt(noEvent(max(abs(impellerTorque), tau_small)));
  efficiency = speedRatio*torqueRatio;
  annotation(Documentation(info = "<html>
<p>The speed ratio rises slowly, within 4000 s, from 0 to 1.2 at 200 rad/s of the impeller. K = 30/pi w_p / sqrt(tau_p), in revolutions
per minute over the root of newton metres, as it is customary.</p>
</html>"));
end ConverterBench;
