within TenSpeed.Examples;
model RigidClutches "Gearbox at level 4 with clutches and brakes that stick rigidly"
  extends Benches.GearboxL4(gearbox(redeclare model Clutch = Mechanics.Rotational.Components.RigidClutch));
  annotation(
    experiment(StopTime = 8, Tolerance = 1e-6, Interval = 1e-2),
    Documentation(info = "<html>
<p>Reverse, park, neutral and first. Up to three rigid elements act on the four degrees of freedom of the gearsets at a
time; which of them stick is found anew at each event.</p>
</html>"));
end RigidClutches;
