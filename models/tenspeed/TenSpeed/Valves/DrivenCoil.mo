within TenSpeed.Valves;
model DrivenCoil "Coil at level 1: an ideal voltage R_nom i_cmd drives the current"
  extends Interfaces.PartialCoil;
  Electrical.Sources.SignalVoltage source "Driver";
  Electrical.Components.Coil coil(
    final R = R,
    final L = L,
    final k_F = k_F,
    final i_sat = i_sat,
    final backEmf = backEmf) "Coil";
  Electrical.Components.Ground ground "Ground";
equation
  source.v = R_nom*i_cmd;
  connect(source.p, coil.p);
  connect(coil.n, source.n);
  connect(source.n, ground.p);
  connect(coil.flange, flange);
  i = coil.inductor.i;
  annotation(Documentation(info = "<html>
<p>One state, the current: R_nom i_cmd = R i + L di/dt + induced voltage.</p>
</html>"));
end DrivenCoil;
