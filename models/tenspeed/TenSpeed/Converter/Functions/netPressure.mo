within TenSpeed.Converter.Functions;
function netPressure "Pressure that drives the flow: of the three rings less losses"
  input Hydraulics.Units.VolumeFlowRate Q "Flow";
  input Mechanics.Units.AngularVelocity w_p "Speed of the impeller";
  input Mechanics.Units.AngularVelocity w_t "Speed of the turbine";
  input Mechanics.Units.AngularVelocity w_s "Speed of the stator";
  input Geometry g "Circuit";
  output Hydraulics.Units.PressureDifference p "Net pressure, zero in steady flow";
protected
  Mechanics.Units.Ratio s "Share of forward flow";
algorithm
  s := forwardShare(Q, g.Q_0);
  p := g.rho*(
    s*({w_p, w_t, w_s}*momentum(true, Q, w_p, w_t, w_s, g) - lossPressure(true, Q, w_p, w_t, w_s, g))
    - (1 - s)*({w_p, w_t, w_s}*momentum(false, Q, w_p, w_t, w_s, g) - lossPressure(false, Q, w_p, w_t, w_s, g)));
  annotation(
    Inline = true,
    smoothOrder = 2,
    Documentation(info = "<html>
<p>In either direction (sum of torque times speed) / Q less the losses, which act against the flow. With all loss
factors 1 both directions meet at Q = 0; with others they are blended by <code>forwardShare</code>.</p>
</html>"));
end netPressure;
