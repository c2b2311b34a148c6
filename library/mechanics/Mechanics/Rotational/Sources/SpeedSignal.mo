within Mechanics.Rotational.Sources;
model SpeedSignal "Speed prescribed by a signal"
  extends Interfaces.PartialOneFlange;
  Signals.Interfaces.RealInput w(unit = "rad/s") "Speed";
  Units.Angle phi(start = 0) "Angle, the integral of the signal";
equation
  phi = flange.phi;
  der(phi) = w;
  annotation(Documentation(info = "<html>
<p>d phi/dt = w. The angle is a state, since a signal cannot be integrated in closed form; <code>Speed</code> has none. The
signal must be differentiable once where an inertia is attached.</p>
</html>"));
end SpeedSignal;
