within TenSpeed.Valves;
model MainStage "Spool of the main regulator with its chambers and the line"
  extends Interfaces.PartialMainStage;
  parameter Hydraulics.Units.Volume V_line = 1e-3 "Line; chosen: pump outlet, valve body and channels";
  parameter Boolean hasFlowForce = true "true: the jets pull their edges shut" annotation(Evaluate = true);
  replaceable model SpoolModel = Hydraulics.Components.Spool
    constrainedby Hydraulics.Interfaces.PartialSpool "Law of motion" annotation(choicesAllMatching = true);
  replaceable model Chamber = Hydraulics.Components.SpoolChamber
    constrainedby Hydraulics.Interfaces.PartialSpoolChamber "Whether the spool displaces oil"
    annotation(choicesAllMatching = true);
  Hydraulics.Components.Volume volume(
    final fluid = fluid,
    final p_start = p_start,
    n = 3,
    final V_0 = V_line) "Line";
  Hydraulics.Valves.MainRegulatorValve valve(
    redeclare model SpoolModel = SpoolModel,
    redeclare model Chamber = Chamber,
    final fluid = fluid,
    final p_start = p_start,
    final m = m,
    final d_spool = d,
    final hasFlowForce = hasFlowForce,
    c = 5e3,
    F_preload = 180,
    s_start = -180/1.005e6,
    s_max = 3e-3,
    d = 20e-3,
    coverage = 0.5,
    chamfer = 0.2e-3,
    overlapConverter = 0.3e-3,
    overlapLubrication = 0.45e-3,
    overlapSuction = 0.6e-3,
    jetAngle = 1.35,
    A_feedback = 300e-6,
    A_pilot = 450e-6,
    V_feedback = 20e-6,
    V_pilot = 30e-6,
    d_feedback = 4e-3,
    d_pilot = 4.5e-3) "Spool, edges and chambers";
equation
  connect(line, volume.port[1]);
  connect(volume.port[2], valve.line);
  connect(volume.port[3], valve.feedback);
  connect(pilot, valve.pilot);
  connect(valve.converter, converter);
  connect(valve.lubrication, lubrication);
  connect(valve.suction, suction);
  s = valve.spool.s;
  m_oil = volume.m + valve.feedbackChamber.m + valve.pilotChamber.m;
  annotation(Documentation(info = "<html>
<p>A_feedback (p_line - p_0) = F_preload + A_pilot (p_pilot - p_0) + c s + flow forces: 6 bar above the atmosphere without
pilot, 1.5 bar more for each bar of it.</p>
<p>Where the numbers come from: lands and spring chosen so that the line stands within 3 % from 5 to 30 l/min; edges so
that converter, lubrication and suction open one after the other within 1 mm; jets turned by recesses in the spool
(77 degrees to the axis, two thirds of the flow force of a sharp edge); orifices so wide that they hardly delay.</p>
</html>"));
end MainStage;
