within Mechanics.Translational.Sources;
model AccelerationSignal "Acceleration prescribed by a signal"
  extends Interfaces.PartialOneFlange;
  Signals.Interfaces.RealInput a(unit = "m/s2") "Acceleration";
  Units.Position s(start = 0) "Position";
  Units.Velocity v(start = 0) "Speed";
equation
  s = flange.s;
  v = der(s);
  der(v) = a;
  annotation(Documentation(info = "<html>
<p>d<sup>2</sup>s/dt<sup>2</sup> = a: position and speed are states. The signal may jump.</p>
</html>"));
end AccelerationSignal;
