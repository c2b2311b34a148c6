within Mechanics.Translational.Examples;
model PrescribedPosition "A mass follows a prescribed position"
  Sources.Position drive(s_end = 2, startTime = 0.2, duration = 0.5) "Drive";
  Components.Mass mass(m = 0.5) "Body";
  output Units.Velocity error "Difference to the closed form";
protected
  Units.Ratio u "Progress of the ramp";
equation
  connect(drive.flange, mass.flange_a);
  // Closed form: v = (s_end - s_start) / duration * 30 u^2 (1 - u)^2
  u = noEvent(min(1, max(0, (time - 0.2)/0.5)));
  error = mass.v - 120*u^2*(1 - u)^2;
  annotation(
    experiment(StopTime = 1, Tolerance = 1e-6),
    Documentation(info = "<html>
<p>The motion is prescribed, so no state remains; the speed is the derivative of the ramp.</p>
</html>"));
end PrescribedPosition;
