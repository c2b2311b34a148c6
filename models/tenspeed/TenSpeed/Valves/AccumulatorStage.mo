within TenSpeed.Valves;
model AccumulatorStage "Piston of the accumulator valve behind its orifice"
  extends Interfaces.PartialAccumulatorStage;
  parameter Mechanics.Units.TranslationalSpringConstant c = 20e3 "Stiffness of the spring; chosen: 1.25 cm3 per bar";
  parameter Mechanics.Units.Force F_preload = 300 "Force of the spring at position 0; chosen: moves from 6 bar on";
  parameter Mechanics.Units.Position s_max = 15e-3 "Upper end stop; chosen: at 12 bar";
  parameter Hydraulics.Units.Area A = 500e-6 "Piston; chosen: 25 mm";
  parameter Hydraulics.Units.Volume V_chamber = 10e-6 "Chamber at position 0; chosen: piston and drilling";
  parameter Hydraulics.Units.Diameter d_orifice = 2e-3 "Orifice; chosen: fills within 50 ms";
  replaceable model SpoolModel = Hydraulics.Components.Spool
    constrainedby Hydraulics.Interfaces.PartialSpool "Law of motion" annotation(choicesAllMatching = true);
  replaceable model Chamber = Hydraulics.Components.SpoolChamber
    constrainedby Hydraulics.Interfaces.PartialSpoolChamber "Whether the piston displaces oil"
    annotation(choicesAllMatching = true);
  SpoolModel piston(
    final m = m,
    final c = c,
    final F_preload = F_preload,
    final d = d,
    final s_max = s_max,
    final s_start = Hydraulics.Functions.restPosition(F_preload, c, 1e6, 0, s_max)) "Piston with spring and end stops";
  Hydraulics.Components.OrificeFeedback chamber(
    redeclare model Chamber = Chamber,
    final fluid = fluid,
    final p_start = p_start,
    final A = A,
    final V_0 = V_chamber,
    final d_orifice = d_orifice) "Oil in front of the piston";
equation
  connect(port, chamber.port);
  connect(chamber.flange, piston.flange);
  s = piston.s;
  m_oil = chamber.m;
  annotation(Documentation(info = "<html>
<p>A (p - p_0) = F_preload + c s at rest between the stops.</p>
</html>"));
end AccumulatorStage;
