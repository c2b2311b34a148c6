within TenSpeed.Valves;
model TwoWayClutchMap "Two-way-clutch valve at level 5: the position follows at once"
  extends TwoWayClutchSwitch;
equation
  s = if toDrive then stroke else 0;
  annotation(Documentation(info = "<html>
<p>No continuous state; the position jumps.</p>
</html>"));
end TwoWayClutchMap;
