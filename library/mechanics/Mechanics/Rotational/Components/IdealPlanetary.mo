within Mechanics.Rotational.Components;
model IdealPlanetary "Simple planetary gearset without inertia, loss, elasticity or backlash"
  parameter Units.Ratio ratio "Number of ring teeth over number of sun teeth";
  Interfaces.Flange sun "Sun shaft";
  Interfaces.Flange carrier "Carrier shaft";
  Interfaces.Flange ring "Ring shaft";
equation
  // Rolling without slip of the planets on sun and ring
  (1 + ratio)*carrier.phi = sun.phi + ratio*ring.phi;
  // Equal tooth forces at both meshes of a planet
  ring.tau = ratio*sun.tau;
  // No power is lost
  carrier.tau = -(1 + ratio)*sun.tau;
  annotation(Documentation(info = "<html>
<p>w_sun + i w_ring = (1 + i) w_carrier with i = Z_ring / Z_sun (Willis). The torques stand as
tau_sun : tau_ring : tau_carrier = 1 : i : -(1 + i); their powers sum to zero.</p>
<p>Source: R. Willis, Principles of Mechanism (1841), on epicyclic trains.</p>
</html>"));
end IdealPlanetary;
