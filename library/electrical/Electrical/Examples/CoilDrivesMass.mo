within Electrical.Examples;
model CoilDrivesMass "A current moves a plunger against the voltage that it induces"
  Signals.Sources.Constant volts(k = 10) "Voltage";
  Sources.SignalVoltage source "Source";
  Components.Resistor wire(R = 5) "Resistance";
  Components.ForceConverter converter(k_F = 20) "Coil and plunger";
  Components.Ground ground "Ground";
  Mechanics.Translational.Components.Mass plunger(
    m = 0.8,
    s(fixed = true),
    v(fixed = true)) "Plunger";
  output Mechanics.Units.Velocity error "Difference to the closed form";
equation
  connect(volts.y, source.v);
  connect(source.p, wire.p);
  connect(wire.n, converter.p);
  connect(converter.n, source.n);
  connect(source.n, ground.p);
  connect(converter.flange, plunger.flange_a);
  // Closed form: v = u/k (1 - exp(-k^2 t/(m R)))
  error = plunger.v - 0.5*(1 - exp(-100*time));
  annotation(
    experiment(StopTime = 0.05, Tolerance = 1e-8),
    Documentation(info = "<html>
<p>m dv/dt = k i, u = R i + k v: v approaches u / k with the time constant m R / k<sup>2</sup>.</p>
</html>"));
end CoilDrivesMass;
