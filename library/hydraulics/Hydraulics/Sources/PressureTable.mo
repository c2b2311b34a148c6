within Hydraulics.Sources;
model PressureTable "Pressure prescribed by a table over time"
  extends Interfaces.PartialSource;
  parameter Mechanics.Units.Time times[:] "Instants, rising";
  parameter Units.AbsolutePressure values[size(times, 1)] "Pressures at these instants";
equation
  port.p = Functions.interpolate(time, times, values);
  annotation(Documentation(info = "<html>
<p>Linear between the instants, constant outside. Its slope jumps at the instants: put a restriction between it and a
volume.</p>
</html>"));
end PressureTable;
