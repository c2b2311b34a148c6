within TenSpeed.Converter.Functions;
function freeStatorSpeed "Speed at which a stator without one-way clutch turns in steady flow"
  input Hydraulics.Units.VolumeFlowRate Q "Flow";
  input Mechanics.Units.AngularVelocity w_p "Speed of the impeller";
  input Mechanics.Units.AngularVelocity w_t "Speed of the turbine";
  input Geometry g "Circuit";
  output Mechanics.Units.AngularVelocity w_s "Speed; the one-way clutch holds the stator where it is negative";
protected
  Hydraulics.Units.VolumeFlowRate q "Flow that runs forward";
  Real u(unit = "m/s") "Meridional velocity";
algorithm
  q := forwardFlow(Q, g.Q_0);
  u := Q/g.A;
  w_s := g.rho*(
    q*(w_t*g.R_t^2 + u*(g.R_t*tan(g.a_t) - g.R_s*tan(g.a_s)))
    + (q - Q)*(w_p*g.R_s^2 + u*(g.R_s*tan(g.b_p) - g.R_t*tan(g.b_s))))
    /(g.d_s + g.rho*(q*g.R_s^2 + (q - Q)*g.R_t^2));
  annotation(
    Inline = true,
    smoothOrder = 3,
    Documentation(info = "<html>
<p>Where the stator's torque on the oil and the drag of its bearing cancel: tau_s(Q, w_p, w_t, w_s) + d_s w_s = 0, which
is linear in w_s.</p>
</html>"));
end freeStatorSpeed;
