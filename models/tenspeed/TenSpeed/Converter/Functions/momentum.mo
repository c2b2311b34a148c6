within TenSpeed.Converter.Functions;
function momentum "Torques of impeller, turbine and stator on a unit of mass flow, one direction of flow"
  input Boolean forward "true: the law of forward flow";
  input Hydraulics.Units.VolumeFlowRate Q "Flow";
  input Mechanics.Units.AngularVelocity w_p "Speed of the impeller";
  input Mechanics.Units.AngularVelocity w_t "Speed of the turbine";
  input Mechanics.Units.AngularVelocity w_s "Speed of the stator";
  input Geometry g "Circuit";
  output Real h[3](each unit = "m2/s") "Torque over mass flow of impeller, turbine, stator";
protected
  Real u(unit = "m/s") "Meridional velocity";
  Real out_p(unit = "m2/s") "Angular momentum per mass of what leaves the impeller";
  Real out_t(unit = "m2/s") "Angular momentum per mass of what leaves the turbine";
  Real out_s(unit = "m2/s") "Angular momentum per mass of what leaves the stator";
algorithm
  u := Q/g.A;
  if forward then
    out_p := w_p*g.R_p^2 + g.R_p*u*tan(g.a_p);
    out_t := w_t*g.R_t^2 + g.R_t*u*tan(g.a_t);
    out_s := w_s*g.R_s^2 + g.R_s*u*tan(g.a_s);
    h := {out_p - out_s, out_t - out_p, out_s - out_t};
  else
    out_p := w_p*g.R_s^2 + g.R_s*u*tan(g.b_p);
    out_t := w_t*g.R_p^2 + g.R_p*u*tan(g.b_t);
    out_s := w_s*g.R_t^2 + g.R_t*u*tan(g.b_s);
    h := {out_p - out_t, out_t - out_s, out_s - out_p};
  end if;
  annotation(
    Inline = true,
    smoothOrder = 10,
    Documentation(info = "<html>
<p>Euler's equation: what a ring's torque adds is the angular momentum of the oil that leaves it less that of the oil
that leaves the ring before it. Forward oil leaves each ring at its exit radius and angle a; backward, on the way
p - s - t - p, at its entry edge: the exit radius of the ring before it, and the angle b.</p>
</html>"));
end momentum;
