within TenSpeed.Valves;
model AccumulatorVolume "Accumulator valve at level 4: only its volume, one with the line's"
  extends Interfaces.PartialAccumulatorStage;
  parameter Hydraulics.Units.Volume V_chamber = 10e-6 "Chamber; as AccumulatorStage at position 0";
  Hydraulics.Components.Volume volume(
    final fluid = fluid,
    final p_start = p_start,
    n = 1,
    final V_0 = V_chamber) "Chamber";
equation
  connect(port, volume.port[1]);
  s = 0;
  m_oil = volume.m;
  annotation(Documentation(info = "<html>
<p>Directly connected to the line: the compiler lumps both volumes into one pressure.</p>
</html>"));
end AccumulatorVolume;
