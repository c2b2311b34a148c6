within Hydraulics.Valves;
model MainRegulatorValve "Main regulator: three edges relieve the line, feedback opens, spring and pilot close"
  replaceable package Oil = Media.OilDexronVI constrainedby Media.PartialOil "Oil whose data are the default"
    annotation(choicesAllMatching = true);
  parameter Media.Fluid fluid = Oil.data "Oil";
  parameter Units.AbsolutePressure p_start = Constants.p_atmosphere "Proposed initial pressure in both chambers";
  // Spool
  parameter Mechanics.Units.Mass m = 1e-3 "Mass of the spool; nominal value of the study";
  parameter Mechanics.Units.TranslationalSpringConstant c = 6e3
    "Stiffness of the spring; chosen: 6 N over the working stroke of 1 mm, an eighth of the feedback force";
  parameter Mechanics.Units.Force F_preload = 23.5
    "Spring force at position 0; chosen: at 3 bar of pilot and 2 to 40 l/min the line stands at 8.7 to 11.5 bar";
  parameter Units.Coefficient dampingRatio = 0.05
    "Damping of spool and spring, relative to critical; nominal damping factor of the study";
  parameter Mechanics.Units.TranslationalDampingConstant d_spool = 2*dampingRatio*sqrt(c*m) "Damping";
  parameter Mechanics.Units.Position s_start = 0 "Proposed initial position of the spool";
  parameter Mechanics.Units.Position s_max = 5e-3 "Position of the upper end stop; chosen: 3.7 mm behind the last edge";
  // Edges
  parameter Units.Diameter d = 14e-3 "Diameter of the spool at its edges; chosen: usual for main regulators";
  parameter Units.Fraction coverage = 0.25 "Part of the circumference that is port; chosen: stable from 1 to 60 l/min";
  parameter Mechanics.Units.Length clearance = 10e-6 "Radial clearance; chosen: usual for transmission spools";
  parameter Mechanics.Units.Length chamfer = 0.3e-3 "Axial length of the chamfers; chosen: soft opening";
  parameter Mechanics.Units.Length overlapConverter = 0.5e-3 "Overlap of the converter edge; chosen: opens first";
  parameter Mechanics.Units.Length overlapLubrication = 0.9e-3 "Overlap of the lubrication edge; chosen: opens second";
  parameter Mechanics.Units.Length overlapSuction = 1.3e-3 "Overlap of the suction edge; chosen: opens last";
  parameter Mechanics.Units.Angle jetAngle = 1.2042771838760873 "Angle of the jets to the axis; von Mises: 69 degrees";
  parameter Boolean hasFlowForce = true "true: the jets pull their edges shut" annotation(Evaluate = true);
  // Chambers
  parameter Units.Area A_feedback = 50e-6 "Area of the feedback land; chosen: 50 N at 10 bar";
  parameter Units.Area A_pilot = 50e-6 "Area of the pilot land; chosen: 1 bar of pilot raises the line by 1 bar";
  parameter Units.Volume V_feedback = 2e-6 "Feedback chamber at position 0; chosen: land and drilling";
  parameter Units.Volume V_pilot = 2e-6 "Pilot chamber at position 0; chosen: land and drilling";
  parameter Units.Diameter d_feedback = 1.2e-3
    "Feedback orifice; chosen: damps the spool, overshoot of a third when the pump starts";
  parameter Units.Diameter d_pilot = 1.5e-3 "Pilot orifice; chosen: wider than the feedback orifice";
  // Connections
  Interfaces.Port line "Line pressure at the edges";
  Interfaces.Port feedback "Line pressure before the feedback orifice";
  Interfaces.Port pilot "Pilot pressure before the pilot orifice";
  Interfaces.Port converter "Outlet that opens first, to the torque converter";
  Interfaces.Port lubrication "Outlet that opens second, to lubrication";
  Interfaces.Port suction "Outlet that opens last, back to the pump's inlet";
  // Parts
  replaceable model SpoolModel = Components.Spool constrainedby Interfaces.PartialSpool "Law of motion"
    annotation(choicesAllMatching = true);
  replaceable model Chamber = Components.SpoolChamber constrainedby Interfaces.PartialSpoolChamber
    "Whether the spool displaces oil in its chambers" annotation(choicesAllMatching = true);
  SpoolModel spool(
    final m = m,
    final c = c,
    final F_preload = F_preload,
    final d = d_spool,
    final s_max = s_max,
    final s_start = s_start) "Spool with spring and end stops";
  Components.SpoolEdge converterEdge(
    final fluid = fluid,
    final overlap = overlapConverter,
    final d = d,
    final coverage = coverage,
    final clearance = clearance,
    final chamfer = chamfer,
    final jetAngle = jetAngle,
    final hasFlowForce = hasFlowForce) "Line to converter";
  Components.SpoolEdge lubricationEdge(
    final fluid = fluid,
    final overlap = overlapLubrication,
    final d = d,
    final coverage = coverage,
    final clearance = clearance,
    final chamfer = chamfer,
    final jetAngle = jetAngle,
    final hasFlowForce = hasFlowForce) "Line to lubrication";
  Components.SpoolEdge suctionEdge(
    final fluid = fluid,
    final overlap = overlapSuction,
    final d = d,
    final coverage = coverage,
    final clearance = clearance,
    final chamfer = chamfer,
    final jetAngle = jetAngle,
    final hasFlowForce = hasFlowForce) "Line to the pump's inlet";
  Components.Orifice feedbackOrifice(final fluid = fluid, final d = d_feedback) "Damps the feedback";
  Chamber feedbackChamber(
    final fluid = fluid,
    final p_start = p_start,
    final pushes = Types.Direction.Positive,
    final A = A_feedback,
    final V_0 = V_feedback) "Opens the valve";
  Components.Orifice pilotOrifice(final fluid = fluid, final d = d_pilot) "Damps the pilot";
  Chamber pilotChamber(
    final fluid = fluid,
    final p_start = p_start,
    final pushes = Types.Direction.Negative,
    final A = A_pilot,
    final V_0 = V_pilot) "Closes the valve";
equation
  // Metering edges
  connect(line, converterEdge.port_a);
  connect(line, lubricationEdge.port_a);
  connect(line, suctionEdge.port_a);
  connect(converterEdge.port_b, converter);
  connect(lubricationEdge.port_b, lubrication);
  connect(suctionEdge.port_b, suction);
  // Feedback and pilot
  connect(feedback, feedbackOrifice.port_a);
  connect(feedbackOrifice.port_b, feedbackChamber.port);
  connect(pilot, pilotOrifice.port_a);
  connect(pilotOrifice.port_b, pilotChamber.port);
  // One rigid spool
  connect(spool.flange, converterEdge.flange);
  connect(spool.flange, lubricationEdge.flange);
  connect(spool.flange, suctionEdge.flange);
  connect(spool.flange, feedbackChamber.flange);
  connect(spool.flange, pilotChamber.flange);
  annotation(Documentation(info = "<html>
<p>In balance A_feedback (p_line - p_0) = F_preload + c s + A_pilot (p_pilot - p_0) + flow forces. States: position and
speed of the spool, pressure in both chambers.</p>
</html>"));
end MainRegulatorValve;
