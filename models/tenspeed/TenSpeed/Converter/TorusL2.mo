within TenSpeed.Converter;
model TorusL2 "Level 2: the flow is steady, the speeds of impeller, turbine and stator are states"
  extends PartialDynamicStator;
  SteadyFlow steadyFlow(
    final geometry = geometry,
    final w_p = w_p,
    final w_t = w_t) "Flow";
equation
  // Angular momentum
  geometry.I_p*der(w_p) = impeller.tau - tau_h[1];
  geometry.I_t*der(w_t) = turbine.tau - tau_h[2];
  geometry.I_s*a_s = tau_s - geometry.d_s*w_s - tau_h[3];
  // Steady flow
  Q = steadyFlow.Q;
  annotation(Documentation(info = "<html>
<p>I<sub>i</sub> dw<sub>i</sub>/dt = tau<sub>i</sub> - tau_h<sub>i</sub> for each ring. The flow is that of
the whole circuit in steady state at the present speeds of impeller and turbine; p_net differs from 0 while the stator
spins up. With the stator's own speed there instead, several flows near zero would fulfil p_net = 0, and the flow would
jump between them all the time.</p>
<p>The shape factors S
exchange energy between the rings' motion and the flow's; without the flow's inertia both of their terms go, so that
energy is conserved.</p>
</html>"));
end TorusL2;
