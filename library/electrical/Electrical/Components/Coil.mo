within Electrical.Components;
model Coil "Coil of a solenoid: resistance, inductance, force on the plunger and induced voltage"
  parameter Units.Resistance R "Resistance";
  parameter Units.Inductance L "Inductance";
  parameter Units.ForceConstant k_F "Force per current at small current";
  parameter Units.Current i_sat(min = 1e-6) = 1e3 "Current at which iron saturates; default: practically linear";
  parameter Mechanics.Units.Ratio backEmf = 1 "Factor on the induced voltage; 1 conserves energy";
  Interfaces.Pin p "Positive pin";
  Interfaces.Pin n "Negative pin";
  Mechanics.Translational.Interfaces.Flange flange "Plunger";
  Resistor resistor(final R = R) "Of the wire";
  Inductor inductor(final L = L) "Of the coil";
  ForceConverter converter(final k_F = k_F, final i_sat = i_sat, final backEmf = backEmf) "Coil and plunger";
equation
  // In series
  connect(p, resistor.p);
  connect(resistor.n, inductor.p);
  connect(inductor.n, converter.p);
  connect(converter.n, n);
  connect(converter.flange, flange);
  annotation(Documentation(info = "<html>
<p>v = R i + L di/dt + backEmf df/di ds/dt, f(i) as in <code>ForceConverter</code>. One state, the current.</p>
</html>"));
end Coil;
