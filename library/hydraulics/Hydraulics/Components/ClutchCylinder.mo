within Hydraulics.Components;
model ClutchCylinder "Cylinder of a clutch: feed orifice, chamber and piston, at rest or turning with a shaft"
  replaceable package Oil = Media.OilDexronVI constrainedby Media.PartialOil "Oil whose data are the default"
    annotation(choicesAllMatching = true);
  parameter Media.Fluid fluid = Oil.data "Oil";
  parameter Units.Area A "Area of the piston";
  parameter Units.Volume V_0 = 100e-6 "Dead volume; nominal value of the study";
  parameter Units.Diameter d_feed = 3e-3 "Feed orifice; chosen: fills the chamber within 0.2 s at 5 bar";
  // Rotation of the chamber
  parameter Boolean rotating = false "true: the chamber turns with w and the oil's centrifugal force acts"
    annotation(Evaluate = true);
  parameter Mechanics.Units.Length r_o = 0.08 "Outer radius of the chamber; chosen: fits the default plates";
  parameter Mechanics.Units.Length r_i = 0.05 "Inner radius of the chamber; chosen: fits the default plates";
  parameter Mechanics.Units.Length r_p = 0.03 "Radius at which the oil enters; chosen: at the shaft";
  parameter Mechanics.Units.Length r_oc = 0.077 "Outer radius of the cancellation chamber; chosen: nearly cancels";
  parameter Mechanics.Units.Length r_ic = 0.05 "Inner radius of the cancellation chamber; chosen: as the chamber";
  parameter Mechanics.Units.Length r_pc = 0.03 "Radius at which oil enters the cancellation chamber; chosen: as above";
  Interfaces.Port port "Feed";
  Signals.Interfaces.RealInput w(unit = "rad/s") "Speed of the chamber";
  Signals.Interfaces.RealOutput f_normal(unit = "N") "Force on the plate pack";
  Orifice feed(final fluid = fluid, final d = d_feed) "Feed orifice";
  SpoolChamber chamber(final fluid = fluid, final A = A, final V_0 = V_0) "Pressure chamber";
  replaceable Mechanics.Translational.Components.ClutchPiston piston "Piston, return spring and plate pack";
  Mechanics.Translational.Sources.ForceSignal centrifugal "Oil that turns with the chamber";
equation
  // Oil
  connect(port, feed.port_a);
  connect(feed.port_b, chamber.port);
  // Piston
  connect(chamber.flange, piston.flange);
  connect(centrifugal.flange, piston.flange);
  connect(piston.f_normal, f_normal);
  // Pressure chamber against cancellation chamber
  centrifugal.f = if rotating then
    Functions.centrifugalForce(w, r_o, r_i, r_p, Media.density(fluid.p_ref, fluid))
    - Functions.centrifugalForce(w, r_oc, r_ic, r_pc, Media.density(fluid.p_ref, fluid)) else 0;
  annotation(Documentation(info = "<html>
<p>Three states: position and velocity of the piston, pressure in the chamber. On a turning shaft the oil's centrifugal
force F_cent - F_cancel acts as well: see <code>Functions.centrifugalForce</code>. A pressure prescribed at the port
stands upstream of the feed orifice.</p>
</html>"));
end ClutchCylinder;
