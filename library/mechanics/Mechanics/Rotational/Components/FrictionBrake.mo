within Mechanics.Rotational.Components;
model FrictionBrake "Friction brake with a choice of how its plates stick"
  extends Interfaces.PartialOneFlange;
  parameter Types.StickLaw law = Types.StickLaw.elastic "How the plates stick" annotation(Evaluate = true);
  parameter Integer N_f(min = 1) = 6 "Number of friction surfaces; chosen: three friction plates";
  Signals.Interfaces.RealInput f_normal(unit = "N") "Normal force; none where it is negative";
  FrictionClutch plates(final law = law, final N_f = N_f) "Plates";
  Fixed case "Case";
equation
  connect(case.flange, plates.flange_a);
  connect(flange, plates.flange_b);
  connect(f_normal, plates.f_normal);
  annotation(Documentation(info = "<html>
<p>A <code>FrictionClutch</code> against the case.</p>
</html>"));
end FrictionBrake;
