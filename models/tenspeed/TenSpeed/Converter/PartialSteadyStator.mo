within TenSpeed.Converter;
partial model PartialSteadyStator "Circuit whose rings have no inertia"
  extends PartialCircuit;
  Boolean held "Whether the one-way clutch holds the stator";
  Mechanics.Units.AngularVelocity w_free(nominal = 100) "Speed of the stator without one-way clutch";
equation
  // Steady torques
  impeller.tau = tau_h[1];
  turbine.tau = tau_h[2];
  // One-way clutch
  w_free = Functions.freeStatorSpeed(Q, w_p, w_t, geometry);
  held = w_free <= 0;
  w_s = smooth(0, noEvent(max(0, w_free)));
  tau_s = tau_h[3] + geometry.d_s*w_s;
  annotation(Documentation(info = "<html>
<p>The stator turns with the larger of 0 and the speed at which no torque acts on it. Release and catch are an event;
values are continuous there.</p>
</html>"));
end PartialSteadyStator;
