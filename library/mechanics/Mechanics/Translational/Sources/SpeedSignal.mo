within Mechanics.Translational.Sources;
model SpeedSignal "Speed prescribed by a signal"
  extends Interfaces.PartialOneFlange;
  Signals.Interfaces.RealInput v(unit = "m/s") "Speed";
  Units.Position s(start = 0) "Position, the integral of the signal";
equation
  s = flange.s;
  der(s) = v;
  annotation(Documentation(info = "<html>
<p>ds/dt = v. The position is a state, since a signal cannot be integrated in closed form; <code>Speed</code> has none.
The signal must be differentiable once where a mass is attached.</p>
</html>"));
end SpeedSignal;
