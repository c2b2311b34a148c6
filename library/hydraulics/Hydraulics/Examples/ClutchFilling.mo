within Hydraulics.Examples;
model ClutchFilling "Clutch cylinder is filled: the piston passes its lash and presses the plates"
  Sources.PressureSource supply(p_start = 1e5, p_end = 8e5, startTime = 0.1, duration = 0.1) "Prescribed pressure";
  Components.ClutchCylinder cylinder(A = 60e-4, rotating = true) "Cylinder on a turning shaft";
  Signals.Sources.Constant speed(k = 200) "Speed of the shaft";
  output Mechanics.Units.Force error "Difference to the balance of forces at rest";
equation
  connect(supply.port, cylinder.port);
  connect(speed.y, cylinder.w);
  // Closed form at rest
  error = cylinder.A*(supply.port.p - Constants.p_atmosphere) + cylinder.centrifugal.f - cylinder.piston.F_preload
    - cylinder.piston.c*cylinder.piston.s - cylinder.f_normal;
  annotation(
    experiment(StopTime = 1, Tolerance = 1e-6),
    Documentation(info = "<html>
<p>At rest A (p - p_0) + F_cent - F_cancel = F_preload + c s + f_normal. <code>error</code> vanishes at the end.</p>
</html>"));
end ClutchFilling;
