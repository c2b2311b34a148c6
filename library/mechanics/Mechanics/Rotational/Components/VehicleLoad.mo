within Mechanics.Rotational.Components;
model VehicleLoad "Vehicle on an output shaft: mass and drag"
  extends Interfaces.PartialOneFlange;
  parameter Units.Mass M "Mass of the vehicle";
  parameter Units.Length R_tire "Radius of the tires";
  parameter Units.Ratio Z_FD "Ratio of the final drive";
  parameter Units.Area C_DA "Drag coefficient times frontal area";
  parameter Units.Density rho = 1.2 "Density of air; chosen: at 20 degrees and sea level";
  final parameter Units.DragConstant c_drag = 0.5*rho*C_DA*(R_tire/Z_FD)^3 "Drag over speed squared";
  Inertia inertia(
    final J = M*(R_tire/Z_FD)^2,
    stateSelect = StateSelect.prefer) "Mass of the vehicle";
  Sources.TorqueSignal drag "Air";
  Units.Torque tau_aero "Drag, against the motion";
  Units.Velocity v "Speed of the vehicle";
equation
  connect(flange, inertia.flange_a);
  connect(inertia.flange_b, drag.flange);
  // Drag at the output shaft
  tau_aero = c_drag*inertia.w*noEvent(abs(inertia.w));
  drag.tau = -tau_aero;
  // Motion on the road
  v = inertia.w*R_tire/Z_FD;
  annotation(Documentation(info = "<html>
<p>J = M (R_tire/Z_FD)<sup>2</sup>; drag 1/2 rho C_D A (R_tire/Z_FD)<sup>3</sup> w |w| against the motion.</p>
</html>"));
end VehicleLoad;
