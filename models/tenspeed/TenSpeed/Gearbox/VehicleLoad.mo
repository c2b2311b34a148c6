within TenSpeed.Gearbox;
model VehicleLoad "Vehicle on the output shaft: mass and drag"
  extends Mechanics.Rotational.Interfaces.PartialOneFlange;
  parameter Mechanics.Units.Mass M = 1900 "Mass of the vehicle";
  parameter Mechanics.Units.Length R_tire = 0.33 "Radius of the tires";
  parameter Mechanics.Units.Ratio Z_FD = 3.61 "Ratio of the final drive";
  parameter Mechanics.Units.Area C_DA = 0.75 "Drag coefficient times frontal area";
  parameter Mechanics.Units.Density rho = 1.2 "Density of air";
  final parameter Real c_drag(final unit = "N.m.s2/rad2") = 0.5*rho*C_DA*(R_tire/Z_FD)^3 "Drag over speed squared";
  Mechanics.Rotational.Components.Inertia inertia(
    final J = M*(R_tire/Z_FD)^2,
    stateSelect = StateSelect.prefer) "Mass of the vehicle";
  Mechanics.Rotational.Sources.TorqueSignal drag "Air";
  Mechanics.Units.Torque tau_aero "Drag, against the motion";
equation
  connect(flange, inertia.flange_a);
  connect(inertia.flange_b, drag.flange);
  // Drag at the output shaft
  tau_aero = c_drag*inertia.w*noEvent(abs(inertia.w));
  drag.tau = -tau_aero;
  annotation(Documentation(info = "<html>
<p>J = M (R_tire/Z_FD)<sup>2</sup>; drag 1/2 rho C_D A (R_tire/Z_FD)<sup>3</sup> w |w| against the motion.</p>
</html>"));
end VehicleLoad;
