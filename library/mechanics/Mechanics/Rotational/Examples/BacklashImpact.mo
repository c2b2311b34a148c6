within Mechanics.Rotational.Examples;
model BacklashImpact "Inertia turns freely through the play of a coupling, then swings on its spring"
  parameter Units.AngularVelocity w_0 = 2 "Initial speed";
  Components.Inertia rotor(J = 0.5, phi(start = 0, fixed = true), w(start = w_0, fixed = true)) "Rotor";
  Components.ElasticBacklash coupling(c = 800, b = 0.2) "Elastic coupling with play";
  Components.Fixed held "Held shaft";
  final parameter Units.AngularVelocity omega = sqrt(coupling.c/rotor.J) "Angular frequency in contact";
  final parameter Units.Time t_contact = coupling.b/2/w_0 "First contact";
  final parameter Units.Time t_release = t_contact + 3.141592653589793/omega "Release";
  output Units.Angle error "Difference to the closed form until the second contact";
equation
  connect(held.flange, coupling.flange_a);
  connect(coupling.flange_b, rotor.flange_a);
  // Closed form: free, half a swing, free backwards
  error = rotor.phi - noEvent(
    if time < t_contact then w_0*time
    else if time < t_release then coupling.b/2 + w_0/omega*sin(omega*(time - t_contact))
    else coupling.b/2 - w_0*(time - t_release));
  annotation(
    experiment(StopTime = 0.2, Tolerance = 1e-6),
    Documentation(info = "<html>
<p>Free motion w_0 t until the play b/2 is used up, half a period of sin(omega t) with omega<sup>2</sup> = c/J, then free
motion back at the same speed: no energy is lost without damping.</p>
</html>"));
end BacklashImpact;
