within TenSpeed.Valves;
model TwoWayClutchHysteresis "Two-way-clutch valve at level 3: the detents as hysteresis, the spool follows in first order"
  extends TwoWayClutchSwitch;
  parameter Mechanics.Units.Time T = 2.8e-3 "Time constant of the way; calibrated on TwoWayClutchValveL1";
  Mechanics.Units.Position way(start = 0) "Position";
equation
  T*der(way) = (if toDrive then stroke else 0) - way;
  s = way;
  annotation(Documentation(info = "<html>
<p>T ds/dt = target - s; the target changes when the pressures overcome the detents.</p>
</html>"));
end TwoWayClutchHysteresis;
