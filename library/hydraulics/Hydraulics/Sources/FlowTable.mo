within Hydraulics.Sources;
model FlowTable "Volume flow prescribed by a table over time"
  extends Interfaces.PartialSource;
  parameter Mechanics.Units.Time times[:] "Instants, rising";
  parameter Units.VolumeFlowRate values[size(times, 1)] "Flows out of the source at these instants";
  Units.VolumeFlowRate q "Flow out of the source";
equation
  q = Functions.interpolate(time, times, values);
  port.q = -q;
  annotation(Documentation(info = "<html>
<p>Linear between the instants, constant outside.</p>
</html>"));
end FlowTable;
