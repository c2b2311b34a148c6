within TenSpeed.Valves;
model LockupMap "Lock-up control valve at level 5: outlet pressure from command and supply"
  extends Interfaces.PartialLockupStage;
  parameter Mechanics.Units.Ratio gain = 1.4697 "Outlet pressure per command pressure; calibrated on LockupControlL1";
  parameter Hydraulics.Units.PressureDifference p_offset = 2.133e5 "Force of the spring over A_1; calibrated likewise";
  parameter Mechanics.Units.Ratio w_round = 0.02 "Rounding of the weight at 0 and 1; chosen: differentiable";
  parameter Hydraulics.Units.AbsolutePressure p_0 = 101325 "Atmosphere";
  Hydraulics.Valves.ThreeWayMap map(final fluid = fluid) "Outlet pressure";
  Real wanted(unit = "1") "Weight without limits";
equation
  connect(supply, map.supply);
  connect(drain, map.drain);
  connect(outlet, map.outlet);
  // Wanted pressure as a weight, limited to what supply and drain can give
  wanted = (gain*(command.p - p_0) - p_offset + p_0 - drain.p)/(supply.p - drain.p);
  map.w = (1 + sqrt(wanted^2 + w_round^2) - sqrt((wanted - 1)^2 + w_round^2))/2;
  command.q = 0;
  s = 0;
  m_oil = 0;
  annotation(Documentation(info = "<html>
<p>p_outlet = p_0 + gain (p_command - p_0) - p_offset between drain and supply. No state.</p>
</html>"));
end LockupMap;
