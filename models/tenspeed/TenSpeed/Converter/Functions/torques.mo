within TenSpeed.Converter.Functions;
function torques "Torques of impeller, turbine and stator on the oil in steady flow"
  input Hydraulics.Units.VolumeFlowRate Q "Flow";
  input Mechanics.Units.AngularVelocity w_p "Speed of the impeller";
  input Mechanics.Units.AngularVelocity w_t "Speed of the turbine";
  input Mechanics.Units.AngularVelocity w_s "Speed of the stator";
  input Geometry g "Circuit";
  output Mechanics.Units.Torque tau[3] "Torques of impeller, turbine, stator; their sum is zero";
protected
  Hydraulics.Units.VolumeFlowRate q "Flow that runs forward";
algorithm
  q := forwardFlow(Q, g.Q_0);
  tau := g.rho*q*momentum(true, Q, w_p, w_t, w_s, g) + g.rho*(q - Q)*momentum(false, Q, w_p, w_t, w_s, g);
  annotation(
    Inline = true,
    smoothOrder = 3,
    Documentation(info = "<html>
<p>tau = rho q h_forward + rho (q - Q) h_backward with the forward part q of the flow.</p>
</html>"));
end torques;
