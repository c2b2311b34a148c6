within Mechanics.Rotational.Examples;
model PrescribedSpeed "An inertia follows a prescribed speed"
  Sources.Speed drive(w_start = 5, w_end = 25, startTime = 0.2, duration = 0.5) "Drive";
  Sensors.TorqueSensor sensor "Drive torque";
  Components.Inertia inertia(J = 0.5) "Body";
  output Units.Torque error "Difference to the closed form";
protected
  Units.Ratio u "Progress of the ramp";
equation
  connect(drive.flange, sensor.flange_a);
  connect(sensor.flange_b, inertia.flange_a);
  // Closed form: tau = J (w_end - w_start) / duration * 30 u^2 (1 - u)^2
  u = noEvent(min(1, max(0, (time - 0.2)/0.5)));
  error = sensor.tau - 600*u^2*(1 - u)^2;
  annotation(
    experiment(StopTime = 1, Tolerance = 1e-6),
    Documentation(info = "<html>
<p>The motion is prescribed, so no state remains; the torque is J times the derivative of the speed ramp.</p>
</html>"));
end PrescribedSpeed;
