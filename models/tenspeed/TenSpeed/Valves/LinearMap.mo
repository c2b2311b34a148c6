within TenSpeed.Valves;
model LinearMap "Linear solenoid valve at level 5: outlet pressure by a weight that depends on the current"
  extends Interfaces.PartialSolenoidStage;
  parameter Real weight[4](each unit = "1") = {0.000987, 0.92122, 0.1117, -0.10996}
    "Coefficients of 1, x, x^2, x^3; calibrated on LinearSolenoidL1, see the page on valves";
  parameter Real closed(unit = "1") = 0.00574 "Leakage of the closed valve; calibrated likewise";
  parameter Real x_closed(unit = "1") = 0.02 "Relative current over which it vanishes; chosen: of the spool's first steps";
  parameter Electrical.Units.Current i_ref = 1 "Current at which x is 1";
  parameter Real x_max(unit = "1") = 1.05 "Beyond which the weight no longer grows";
  Hydraulics.Valves.ThreeWayMap map(final fluid = fluid) "Outlet pressure";
  Real x(unit = "1") "Relative current, between 0 and x_max";
equation
  connect(supply, map.supply);
  connect(drain, map.drain);
  connect(outlet, map.outlet);
  // Weight of the supply
  x = smooth(0, noEvent(min(x_max, max(0, i/i_ref))));
  map.w = weight[1] + x*(weight[2] + x*(weight[3] + x*weight[4])) + closed*exp(-x/x_closed);
  // No spool: the plunger rests
  flange.s = 0;
  s = 0;
  m_oil = 0;
  annotation(Documentation(info = "<html>
<p>p_outlet = w(i) p_supply + (1 - w(i)) p_drain with w = weight[1] + weight[2] x + weight[3] x<sup>2</sup> +
weight[4] x<sup>3</sup> + closed exp(-x / x_closed), x = i / i_ref. No state.</p>
</html>"));
end LinearMap;
