within Mechanics.Translational.Examples;
model ElasticStopImpact "A mass flies between elastic stops"
  parameter Units.Velocity v_0 = 2 "Initial speed";
  Components.Mass mass(m = 0.2, s(start = 0, fixed = true), v(start = v_0, fixed = true)) "Body";
  Components.ElasticStops stops(s_min = -1, s_max = 0.02, c = 8e4) "Stops";
  final parameter Real omega(unit = "rad/s") = sqrt(stops.c/mass.m) "Angular frequency in contact";
  final parameter Units.Time t_contact = 0.02/v_0 "First contact";
  final parameter Units.Time t_release = t_contact + Constants.pi/omega "Release";
  output Units.Length error "Difference to the closed form until the second contact";
equation
  connect(mass.flange_b, stops.flange);
  // Closed form: free, half a swing, free backwards
  error = mass.s - noEvent(
    if time < t_contact then v_0*time
    else if time < t_release then 0.02 + v_0/omega*sin(omega*(time - t_contact))
    else 0.02 - v_0*(time - t_release));
  annotation(
    experiment(StopTime = 0.2, Tolerance = 1e-8),
    Documentation(info = "<html>
<p>Free motion, half a period of sin(omega t) with omega<sup>2</sup> = c/m in the stop, free motion back at the same speed.</p>
</html>"));
end ElasticStopImpact;
