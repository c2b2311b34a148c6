within Mechanics.Translational.Examples;
model BouncingMass "A mass falls on a rigid stop, bounces, comes to rest, and is lifted"
  Sources.ForceSignal weight "Weight, and a pull from 3 s on";
  Components.MassWithStops mass(
    m = 0.5,
    s_min = 0,
    s_max = 10,
    e = 0.5,
    s(start = h, fixed = true),
    v(start = 0, fixed = true)) "Body";
  parameter Units.Length h = 1 "Height of the fall";
  parameter Units.Acceleration g = 10 "Weight over mass";
  parameter Units.Acceleration lift = 6 "Pull over mass";
  final parameter Units.Time t_1 = sqrt(2*h/g) "First impact";
  final parameter Units.Time t_2 = 2*t_1 "Second impact: a flight of 2 e t_1";
  output Units.Length error "Difference to the closed form, but between the second impact and rest";
equation
  connect(weight.flange, mass.flange_a);
  weight.f = mass.m*(if time < 3 then -g else lift);
  // Closed form: fall, flight at half the speed of impact; at rest; lifted
  error = mass.s - noEvent(
    if time < t_1 then h - g*time^2/2
    elseif time < t_2 then g*t_1/2*(time - t_1) - g*(time - t_1)^2/2
    elseif time < 2 then mass.s
    elseif time < 3 then 0
    else lift*(time - 3)^2/2);
  annotation(
    experiment(StopTime = 4, Tolerance = 1e-8),
    Documentation(info = "<html>
<p>Each flight takes half as long as the one before: after 3 t_1 = 1.34 s the bounces have died, and the mass rests until it is
pulled off at 3 s.</p>
</html>"));
end BouncingMass;
