within TenSpeed.Converter;
model TorusL4 "Level 4: algebraic"
  extends PartialSteadyStator;
  SteadyFlow steadyFlow(
    final geometry = geometry,
    final w_p = w_p,
    final w_t = w_t) "Flow";
equation
  // Steady flow
  Q = steadyFlow.Q;
  annotation(Documentation(info = "<html>
<p>p_net = 0 and torques of steady flow; no state.</p>
</html>"));
end TorusL4;
