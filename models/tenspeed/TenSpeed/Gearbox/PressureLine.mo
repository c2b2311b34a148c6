within TenSpeed.Gearbox;
block PressureLine "Pressure of an element as commanded, until it fails"
  parameter Mechanics.Units.Time t_fail = 1e6 "Instant of the failure; chosen: never";
  parameter Hydraulics.Units.AbsolutePressure p_fail = 1.01325e5 "Pressure after the failure; chosen: of the air";
  parameter Mechanics.Units.Time duration(min = 1e-9) = 0.02 "Time it takes; chosen: a broken seal";
  Signals.Interfaces.RealInput p_command(unit = "Pa") "Commanded pressure";
  Signals.Interfaces.RealOutput p(unit = "Pa") "Pressure";
equation
  p = p_command + (p_fail - p_command)*Mechanics.Functions.smoothStep((time - t_fail)/duration);
  annotation(Documentation(info = "<html>
<p>p goes from the commanded pressure to p_fail within <code>duration</code> from t_fail on.</p>
</html>"));
end PressureLine;
