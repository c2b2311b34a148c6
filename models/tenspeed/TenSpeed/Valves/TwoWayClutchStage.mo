within TenSpeed.Valves;
model TwoWayClutchStage "Spool of the two-way-clutch valve with four chambers and two detents"
  extends Interfaces.PartialTwoWayClutchStage;
  parameter Hydraulics.Units.Volume V_chamber = 2e-6 "Each chamber at position 0; chosen: land and drilling";
  parameter Hydraulics.Units.Diameter d_orifice = 1.5e-3 "Orifice of each chamber; chosen: passes within 20 ms";
  parameter Mechanics.Units.TranslationalDampingConstant d_detent = 5 "Damping of each detent; chosen: follows within 1 ms";
  parameter Mechanics.Units.TranslationalSpringConstant c_contact = 1e6 "Roller and cam; chosen: small against the hump";
  replaceable model Chamber = Hydraulics.Components.SpoolChamber
    constrainedby Hydraulics.Interfaces.PartialSpoolChamber "Whether the spool displaces oil"
    annotation(choicesAllMatching = true);
  Hydraulics.Components.Spool spool(
    final m = m,
    final c = 0,
    final F_preload = 0,
    final d = d,
    final s_max = stroke,
    b_stop = 5) "Spool between its stops";
  Hydraulics.Components.OrificeFeedback driveChamber[2](
    redeclare each model Chamber = Chamber,
    each final fluid = fluid,
    each final p_start = p_start,
    each final A = A,
    each final V_0 = V_chamber,
    each final d_orifice = d_orifice) "Push to drive";
  Hydraulics.Components.OrificeFeedback reverseChamber[2](
    redeclare each model Chamber = Chamber,
    each final fluid = fluid,
    each final p_start = p_start,
    each final pushes = Hydraulics.Types.Direction.Negative,
    each final A = A,
    each final V_0 = V_chamber + A*stroke,
    each final d_orifice = d_orifice) "Push to reverse";
  Detent detent[2](
    each final stroke = stroke,
    each final hump = hump,
    each final F_preload = F_detent,
    each final c = c_detent,
    each d = d_detent,
    each c_contact = c_contact) "Hold both positions";
equation
  connect(drive, driveChamber.port);
  connect(reverse, reverseChamber.port);
  for k in 1:2 loop
    connect(driveChamber[k].flange, spool.flange);
    connect(reverseChamber[k].flange, spool.flange);
    connect(detent[k].flange, spool.flange);
  end for;
  s = spool.s;
  m_oil = sum(driveChamber.m) + sum(reverseChamber.m);
  annotation(Documentation(info = "<html>
<p>Eight states: s, v, four chambers, two detents.</p>
</html>"));
end TwoWayClutchStage;
