within Mechanics.Translational.Examples;
model DetentSnaps "A mass swings between two notches of a detent"
  Components.Mass mass(m = 0.05, s(start = 2.0e-3, fixed = true), v(start = 0, fixed = true)) "Rod";
  Components.Detent detent "Detent";
  final parameter Units.Energy E_0(fixed = false) "Energy at the start";
  output Real error(unit = "1") "What is missing in the energy balance, relative";
initial equation
  E_0 = detent.storedEnergy;
equation
  connect(mass.flange_a, detent.flange);
  // Energy balance
  error = (0.5*mass.m*mass.v^2 + detent.storedEnergy)/E_0 - 1;
  annotation(
    experiment(StopTime = 0.5, Tolerance = 1e-9),
    Documentation(info = "<html>
<p>Without friction energy of motion + energy of the spring stays what it was: released near the top between two notches, the
mass swings in the nearer one.</p>
</html>"));
end DetentSnaps;
