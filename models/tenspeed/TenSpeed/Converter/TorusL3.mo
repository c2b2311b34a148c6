within TenSpeed.Converter;
model TorusL3 "Level 3: the speeds are steady, the flow is the only state"
  extends PartialSteadyStator;
equation
  // Energy of the flow
  geometry.rho*geometry.L_f/geometry.A*der(Q) = p_net;
  annotation(Documentation(info = "<html>
<p>rho L_f/A dQ/dt = p_net; the torques are those of steady flow. The rings have no inertia and the shape factors no
effect: see level 2.</p>
</html>"));
end TorusL3;
