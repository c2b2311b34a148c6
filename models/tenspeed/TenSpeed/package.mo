package TenSpeed "Ten-speed automatic transmission"
  annotation(
    version = "0.1.0",
    uses(
      Mechanics(version = "0.1.0"),
      Hydraulics(version = "0.1.0"),
      Electrical(version = "0.1.0"),
      Signals(version = "0.1.0")),
    Documentation(info = "<html>
<p>A front-wheel-drive automatic with four planetary gearsets, three clutches, three brakes and one two-way clutch.
<code>Gearbox</code> is one
architecture at four levels, <code>Converter</code> the torque converter at five, <code>Valves</code> the hydraulic parts
by level; <code>Benches</code> drive them, <code>Failures</code> break them.</p>
</html>"));
end TenSpeed;
