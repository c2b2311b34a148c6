within Mechanics.Rotational.Examples;
model PrescribedAngle "An inertia follows a prescribed angle"
  Sources.Position drive(phi_end = 2, startTime = 0.2, duration = 0.5) "Drive";
  Components.Inertia inertia(J = 0.5) "Body";
  Sensors.MotionSensor sensor "Motion of the body";
  output Units.AngularVelocity error "Difference to the closed form";
protected
  Units.Ratio u "Progress of the ramp";
equation
  connect(drive.flange, inertia.flange_a);
  connect(inertia.flange_b, sensor.flange);
  // Closed form: w = (phi_end - phi_start) / duration * 30 u^2 (1 - u)^2
  u = noEvent(min(1, max(0, (time - 0.2)/0.5)));
  error = sensor.w - 120*u^2*(1 - u)^2;
  annotation(
    experiment(StopTime = 1, Tolerance = 1e-6),
    Documentation(info = "<html>
<p>The motion is prescribed, so no state remains; the speed is the derivative of the ramp.</p>
</html>"));
end PrescribedAngle;
