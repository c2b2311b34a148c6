within Hydraulics.Examples;
model PipeStart "Oil in a pipe is set in motion by a constant pressure difference"
  Sources.Tank left(p_tank = 2.1e5) "Higher pressure";
  Components.Pipe pipe(d = 6e-3, l = 1, m_flow(fixed = true)) "Pipe under test";
  Sources.Tank right(p_tank = 2e5) "Lower pressure";
  final parameter Units.MassFlowRate m_end = Constants.pi*pipe.d^4*1e4/(128*pipe.fluid.nu*pipe.l) "Flow at the end";
  final parameter Mechanics.Units.Time T = pipe.d^2/(32*pipe.fluid.nu) "Time constant";
  output Real error(unit = "1") "Relative difference to the closed form";
equation
  connect(left.port, pipe.port_a);
  connect(pipe.port_b, right.port);
  // Laminar flow starts exponentially
  error = (pipe.m_flow - m_end*(1 - exp(-time/T)))/m_end;
  annotation(
    experiment(StopTime = 0.2, Tolerance = 1e-8),
    Documentation(info = "<html>
<p>m_flow = pi d<sup>4</sup> dp / (128 nu l) (1 - exp(-t/T)), T = d<sup>2</sup> / (32 nu), as long as the flow is
laminar.</p>
</html>"));
end PipeStart;
