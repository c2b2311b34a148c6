within TenSpeed.Benches;
model GearsetTorque "Slow torque on the sun of a gearset with carrier and ring held"
  parameter Mechanics.Units.Torque tau = 100 "Final torque";
  replaceable model Gearset = Gearbox.HelicalGearset constrainedby Interfaces.PartialGearset "Gearset under test"
    annotation(choicesAllMatching = true);
  parameter Gearbox.GearsetData data = Gearbox.Data.P1 "Its geometry";
  Gearset gearset(data = data) "Gearset under test";
  Mechanics.Rotational.Sources.Torque drive(tau_start = 0, tau_end = tau, startTime = 0, duration = 0.5) "Torque";
  Mechanics.Rotational.Components.Inertia rotor(J = 0.005) "Rotor of the bench; chosen: as light as the sun's shaft";
  Mechanics.Rotational.Components.Fixed carrier "Held carrier";
  Mechanics.Rotational.Components.Fixed ring "Held ring";
  output Mechanics.Units.Angle windUp "Angle of the sun";
  output Mechanics.Units.Torque torque "Torque on the sun";
equation
  connect(drive.flange, rotor.flange_a);
  connect(rotor.flange_b, gearset.sun);
  connect(gearset.carrier, carrier.flange);
  connect(gearset.ring, ring.flange);
  windUp = rotor.phi;
  torque = drive.tau;
  annotation(
    experiment(StopTime = 1, Tolerance = 1e-8),
    Documentation(info = "<html>
<p>At rest windUp = b/2 + tau/c for positive and -b/2 + tau/c for negative torque: two torques of each sign give the
stiffness c and the play b that levels 2 and 3 lump at the sun.</p>
</html>"));
end GearsetTorque;
