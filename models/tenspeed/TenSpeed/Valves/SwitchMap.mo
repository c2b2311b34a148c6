within TenSpeed.Valves;
model SwitchMap "Switch valve at level 5: outlet pressure by a weight that depends on the pilot pressure"
  extends Interfaces.PartialSwitchStage;
  parameter Hydraulics.Units.AbsolutePressure p_switch = 3.61e5
    "Pilot pressure at which the valve is half open; the middle of the hysteresis of SwitchValveL1";
  parameter Hydraulics.Units.PressureDifference p_width = 0.2e5 "Range over which it opens; chosen: small against p_switch";
  parameter Real w_on(unit = "1") = 0.9978 "Weight when open, below 1 by leakage; calibrated on SwitchValveL1";
  Hydraulics.Valves.ThreeWayMap map(final fluid = fluid) "Outlet pressure";
equation
  connect(supply, map.supply);
  connect(drain, map.drain);
  connect(outlet, map.outlet);
  map.w = w_on*Mechanics.Functions.smoothStep((pilot.p - p_switch)/p_width + 0.5);
  flange.s = s_max*map.w;
  pilot.q = 0;
  m_oil = 0;
  annotation(Documentation(info = "<html>
<p>p_outlet = w p_supply + (1 - w) p_drain, w = w_on smoothStep((p_pilot - p_switch) / p_width + 1/2). No state and no
hysteresis: that needs a memory.</p>
</html>"));
end SwitchMap;
