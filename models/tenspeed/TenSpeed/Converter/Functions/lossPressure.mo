within TenSpeed.Converter.Functions;
function lossPressure "Shock and friction losses of one direction of flow, over the density"
  input Boolean forward "true: the law of forward flow";
  input Hydraulics.Units.VolumeFlowRate Q "Flow";
  input Mechanics.Units.AngularVelocity w_p "Speed of the impeller";
  input Mechanics.Units.AngularVelocity w_t "Speed of the turbine";
  input Mechanics.Units.AngularVelocity w_s "Speed of the stator";
  input Geometry g "Circuit";
  output Real e(unit = "m2/s2") "Energy lost per mass";
protected
  Real u(unit = "m/s") "Meridional velocity";
  Real V[3](each unit = "m/s") "Shock velocities of impeller, turbine, stator";
  Real walls(unit = "1") "Sum of the squared wall velocities over the squared meridional velocity";
algorithm
  u := Q/g.A;
  if forward then
    V := {
      g.R_s*(w_s - w_p) + u*(tan(g.a_s) - tan(g.b_p)),
      g.R_p*(w_p - w_t) + u*(tan(g.a_p) - tan(g.b_t)),
      g.R_t*(w_t - w_s) + u*(tan(g.a_t) - tan(g.b_s))};
    walls := 1/cos(g.a_p)^2 + 1/cos(g.a_t)^2 + 1/cos(g.a_s)^2;
  else
    V := {
      g.R_p*(w_t - w_p) + u*(tan(g.b_t) - tan(g.a_p)),
      g.R_t*(w_s - w_t) + u*(tan(g.b_s) - tan(g.a_t)),
      g.R_s*(w_p - w_s) + u*(tan(g.b_p) - tan(g.a_s))};
    walls := 1/cos(g.b_p)^2 + 1/cos(g.b_t)^2 + 1/cos(g.b_s)^2;
  end if;
  e := (g.C_p*V[1]^2 + g.C_t*V[2]^2 + g.C_s*V[3]^2 + g.f*walls*u^2)/2;
  annotation(
    Inline = true,
    smoothOrder = 10,
    Documentation(info = "<html>
<p>e = (C_p V_p<sup>2</sup> + C_t V_t<sup>2</sup> + C_s V_s<sup>2</sup>) / 2 + f (W_p<sup>2</sup> + W_t<sup>2</sup> +
W_s<sup>2</sup>) / 2: V is the change of the tangential velocity at the edge that the oil enters, W = u / cos of the
blade's angle the velocity along the walls.</p>
</html>"));
end lossPressure;
