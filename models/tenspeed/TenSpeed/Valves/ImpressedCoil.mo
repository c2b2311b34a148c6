within TenSpeed.Valves;
model ImpressedCoil "Coil at level 2 and below: the command is the current"
  extends Interfaces.PartialCoil;
  Electrical.Sources.SignalCurrent source "Driver";
  Electrical.Components.ForceConverter converter(
    final k_F = k_F,
    final i_sat = i_sat,
    final backEmf = backEmf) "Coil and plunger";
  Electrical.Components.Ground ground "Ground";
equation
  connect(i_cmd, source.i);
  connect(source.p, converter.p);
  connect(converter.n, source.n);
  connect(source.n, ground.p);
  connect(converter.flange, flange);
  i = converter.i;
  annotation(Documentation(info = "<html>
<p>No state. The resistance is without effect: an ideal driver controls the current.</p>
</html>"));
end ImpressedCoil;
