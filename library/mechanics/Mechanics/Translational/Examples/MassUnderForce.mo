within Mechanics.Translational.Examples;
model MassUnderForce "A constant force accelerates a mass"
  Sources.Force drive(f_start = 2) "Drive";
  Components.Mass mass(
    m = 0.5,
    s(start = 0, fixed = true),
    v(start = v_0, fixed = true)) "Body";
  parameter Units.Velocity v_0 = 1 "Speed at time 0";
  output Units.Length error "Difference to the closed form";
equation
  connect(drive.flange, mass.flange_a);
  // Closed form: s = v_0 t + f t^2 / (2 m)
  error = mass.s - (v_0*time + drive.f_start*time^2/(2*mass.m));
  annotation(
    experiment(StopTime = 1, Tolerance = 1e-6),
    Documentation(info = "<html>
<p>s = v_0 t + f t<sup>2</sup> / (2 m).</p>
</html>"));
end MassUnderForce;
