within TenSpeed.Valves;
model ShiftMap "Shift solenoid valve at level 5: outlet pressure by a weight that depends on the current"
  extends Interfaces.PartialSolenoidStage;
  parameter Electrical.Units.Current i_off = 0.3615 "The outlet is drained below; calibrated on ShiftSolenoidL1";
  parameter Electrical.Units.Current i_on = 0.3985 "The outlet is filled above; calibrated on ShiftSolenoidL1";
  parameter Real w_on(unit = "1") = 0.994 "Weight when filled, below 1 by leakage; calibrated on ShiftSolenoidL1";
  Hydraulics.Valves.ThreeWayMap map(final fluid = fluid) "Outlet pressure";
equation
  connect(supply, map.supply);
  connect(drain, map.drain);
  connect(outlet, map.outlet);
  // Weight of the supply
  map.w = w_on*Mechanics.Functions.smoothStep((i - i_off)/(i_on - i_off));
  // No plunger
  flange.s = 0;
  s = 0;
  m_oil = 0;
  annotation(Documentation(info = "<html>
<p>p_outlet = w(i) p_supply + (1 - w(i)) p_drain, w = w_on smoothStep((i - i_off) /
(i_on - i_off)). No state.</p>
</html>"));
end ShiftMap;
