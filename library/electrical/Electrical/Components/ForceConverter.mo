within Electrical.Components;
model ForceConverter "Current makes force, motion makes voltage"
  extends Interfaces.PartialTwoPin;
  parameter Units.ForceConstant k_F "Force per current at small current";
  parameter Units.Current i_sat(min = 1e-6) = 1e3 "Current at which iron saturates; default: practically linear";
  parameter Mechanics.Units.Ratio backEmf = 1 "Factor on the induced voltage; 1 conserves energy";
  Mechanics.Translational.Interfaces.Flange flange "Plunger";
  Mechanics.Units.Force f "Magnetic force, pushes towards positive position";
equation
  // Current to force, saturating
  f = k_F*i/sqrt(1 + (i/i_sat)^2);
  flange.f = -f;
  // Motion to voltage, with the slope of the force
  v = backEmf*k_F/(1 + (i/i_sat)^2)^1.5*der(flange.s);
  annotation(Documentation(info = "<html>
<p>f = k_F i / sqrt(1 + (i / i_sat)<sup>2</sup>), v = backEmf df/di ds/dt. Without saturation and with backEmf = 1
the electric power v i is the mechanical power f ds/dt. Both follow from the co-energy f(i) s; the change of inductance
with the current beyond saturation is left out.</p>
</html>"));
end ForceConverter;
