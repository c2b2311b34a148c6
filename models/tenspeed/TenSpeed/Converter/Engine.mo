within TenSpeed.Converter;
model Engine "Engine: inertia, torque by a signal, idle governor"
  parameter Mechanics.Units.Inertia J = 0.15 "Inertia; chosen: crankshaft and flexplate of a 2 litre engine";
  parameter Mechanics.Units.AngularVelocity w_idle = 80 "Idle speed; chosen: 760 rpm";
  parameter Mechanics.Units.RotationalDampingConstant k = 3 "Gain of the idle governor; chosen: settles within a second";
  parameter Mechanics.Units.AngularVelocity w_start = 80 "Proposed initial speed";
  Shaft shaft "Crankshaft";
  Signals.Interfaces.RealInput tau(unit = "N.m") "Torque of combustion and friction";
  Mechanics.Units.AngularVelocity w(start = w_start, nominal = 100) "Speed";
equation
  w = shaft.w;
  // Newton's law for rotation; the governor only adds
  J*der(w) = tau + k*noEvent(max(0, w_idle - w)) + shaft.tau;
  annotation(Documentation(info = "<html>
<p>J dw/dt = tau + k max(0, w_idle - w) - load.</p>
</html>"));
end Engine;
