within TenSpeed.Valves;
model Detent "Spring-loaded roller on the cam of a spool: a hump between two rest positions"
  parameter Mechanics.Units.Length stroke "Distance between the rest positions 0 and stroke";
  parameter Mechanics.Units.Length hump "Height of the cam half-way";
  parameter Mechanics.Units.Force F_preload "Force of the spring at the rest positions";
  parameter Mechanics.Units.TranslationalSpringConstant c "Stiffness of the spring";
  parameter Mechanics.Units.TranslationalDampingConstant d "Damping of the roller's holder";
  parameter Mechanics.Units.TranslationalSpringConstant c_contact "Stiffness of roller and cam";
  Mechanics.Translational.Interfaces.Flange flange "Spool";
  Mechanics.Units.Length h "Height of the cam under the roller";
  Mechanics.Units.Length y(start = -F_preload/c_contact, nominal = 1e-3) "Compression of the spring";
  Mechanics.Units.Force N(start = 0) "Force between roller and cam";
  Mechanics.Units.Force f "Force on the spool, towards positive position";
protected
  final parameter Real wave(final unit = "1/m") = 2*Hydraulics.Constants.pi/stroke "Of the cam";
equation
  // Cam
  h = hump/2*(1 - cos(wave*flange.s));
  // Roller with contact, spring and damper, without mass
  N = Mechanics.Functions.contactForce(h - y, 0, c_contact, 0);
  d*der(y) = N - F_preload - c*(y - y_0);
  // The slope of the cam turns the force
  f = -N*hump/2*wave*sin(wave*flange.s);
  flange.f = -f;
protected
  final parameter Mechanics.Units.Length y_0 = -F_preload/c_contact "Compression at the rest positions";
  annotation(Documentation(info = "<html>
<p>h = hump/2 (1 - cos(2 pi s/stroke)); d dy/dt = N - F_preload - c (y - y_0), N = c_contact (h - y), never pulling; the
spool receives -N dh/ds. One state, the compression y behind its damper: the roller lags when the spool is fast.</p>
</html>"));
end Detent;
