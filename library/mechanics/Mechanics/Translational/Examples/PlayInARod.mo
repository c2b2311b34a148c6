within Mechanics.Translational.Examples;
model PlayInARod "A mass flies through the play of a coupling and loses energy in its damped contact"
  Components.Mass mass(m = 0.3, s(start = 0, fixed = true), v(start = 3, fixed = true)) "Body";
  Components.ElasticBacklash coupling(c = 5e5, d = 200, b = 0.02) "Coupling with play";
  Components.Fixed wall "Case";
  Units.Energy lost(start = 0, fixed = true) "Heat";
  output Units.Energy error "What is missing in the energy balance";
equation
  connect(wall.flange, coupling.flange_a);
  connect(coupling.flange_b, mass.flange_a);
  der(lost) = coupling.lossPower;
  // Energy balance
  error = 0.5*mass.m*(mass.v^2 - 9) + coupling.storedEnergy + lost;
  annotation(
    experiment(StopTime = 0.1, Tolerance = 1e-9),
    Documentation(info = "<html>
<p>Energy of motion + energy of the spring + heat stays what it was.</p>
</html>"));
end PlayInARod;
