within Electrical.Examples;
model CoilSwitchedOn "A voltage is switched to a coil whose plunger is held"
  Signals.Sources.Constant volts(k = 10) "Voltage";
  Sources.SignalVoltage source "Source";
  Components.Coil coil(
    R = 5,
    L = 0.01,
    k_F = 20,
    i_sat = 2,
    inductor(i(fixed = true))) "Coil under test";
  Components.Ground ground "Ground";
  Mechanics.Translational.Components.Fixed holder "Holds the plunger";
  output Units.Current error "Difference to the closed form";
  output Mechanics.Units.Force force = -holder.flange.f "Force on the holder";
equation
  connect(volts.y, source.v);
  connect(source.p, coil.p);
  connect(coil.n, source.n);
  connect(source.n, ground.p);
  connect(coil.flange, holder.flange);
  // Closed form: i = v/R (1 - exp(-R t/L))
  error = coil.resistor.i - 2*(1 - exp(-500*time));
  annotation(
    experiment(StopTime = 0.02, Tolerance = 1e-8),
    Documentation(info = "<html>
<p>i = v / R (1 - exp(-R t / L)). At 2 A, the current of saturation, the force is 20 N/A 2 A / sqrt(2).</p>
</html>"));
end CoilSwitchedOn;
