within Mechanics.Rotational.Interfaces;
partial model PartialCompliant "Massless connection of two shafts that may turn against each other"
  extends PartialTwoFlanges;
  Units.Angle phi_rel(start = 0) "Angle of flange_b relative to flange_a";
  Units.Torque tau "Torque into flange_b";
equation
  // Relative angle
  phi_rel = flange_b.phi - flange_a.phi;
  // Equilibrium without mass
  flange_b.tau = tau;
  flange_a.tau = -tau;
  annotation(Documentation(info = "<html>
<p>phi_rel = phi_b - phi_a; tau_b = tau = -tau_a. The extending model gives the law for tau.</p>
</html>"));
end PartialCompliant;
