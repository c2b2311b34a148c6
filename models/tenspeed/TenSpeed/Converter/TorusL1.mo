within TenSpeed.Converter;
model TorusL1 "Level 1: speeds of impeller, turbine and stator and flow are states"
  extends PartialDynamicStator;
equation
  // Angular momentum
  geometry.I_p*der(w_p) + geometry.rho*geometry.S_p*der(Q) = impeller.tau - tau_h[1];
  geometry.I_t*der(w_t) + geometry.rho*geometry.S_t*der(Q) = turbine.tau - tau_h[2];
  geometry.I_s*a_s + geometry.rho*geometry.S_s*der(Q) = tau_s - geometry.d_s*w_s - tau_h[3];
  // Energy of the flow
  geometry.rho*(geometry.S_p*der(w_p) + geometry.S_t*der(w_t) + geometry.S_s*a_s + geometry.L_f/geometry.A*der(Q)) =
    p_net;
  annotation(Documentation(info = "<html>
<p>I<sub>i</sub> dw<sub>i</sub>/dt + rho S<sub>i</sub> dQ/dt = tau<sub>i</sub> - tau_h<sub>i</sub> for each ring;
rho &sum; S<sub>i</sub> dw<sub>i</sub>/dt + rho L_f/A dQ/dt = p_net.</p>
<p>Four states: w_p, w_t, w_s, Q, less those that a source prescribes.</p>
</html>"));
end TorusL1;
