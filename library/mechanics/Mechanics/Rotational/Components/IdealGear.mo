within Mechanics.Rotational.Components;
model IdealGear "Gear without inertia, loss, elasticity or backlash"
  extends Interfaces.PartialTwoFlanges;
  parameter Units.Ratio ratio "Transmission ratio phi_a / phi_b";
equation
  // Rolling without slip
  flange_a.phi = ratio*flange_b.phi;
  // No power is lost
  0 = ratio*flange_a.tau + flange_b.tau;
  annotation(Documentation(info = "<html>
<p>phi_a = ratio phi_b; ratio tau_a + tau_b = 0, so that tau_a w_a + tau_b w_b = 0. The case takes the
difference of the torques.</p>
</html>"));
end IdealGear;
