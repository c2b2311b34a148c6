within Mechanics.Rotational.Sources;
model AccelerationSignal "Acceleration prescribed by a signal"
  extends Interfaces.PartialOneFlange;
  Signals.Interfaces.RealInput a(unit = "rad/s2") "Acceleration";
  Units.Angle phi(start = 0) "Angle";
  Units.AngularVelocity w(start = 0) "Speed";
equation
  phi = flange.phi;
  w = der(phi);
  der(w) = a;
  annotation(Documentation(info = "<html>
<p>d<sup>2</sup> phi/dt<sup>2</sup> = a: angle and speed are states. The signal may jump.</p>
</html>"));
end AccelerationSignal;
