within Hydraulics.Components;
model Pipe "Straight pipe with lumped inertia of the oil and friction, laminar or turbulent"
  extends Interfaces.PartialRestriction;
  parameter Units.Diameter d "Inner diameter";
  parameter Mechanics.Units.Length l(min = 0) "Length";
  parameter Units.Coefficient Re_0 = 1187.4
    "Reynolds number at which the laws of laminar and turbulent flow meet: (64/0.3164)^(4/3)";
  final parameter Units.Area A = Constants.pi*d^2/4 "Flow area";
  Units.Coefficient Re "Reynolds number";
  Units.PressureDifference dp_friction "Pressure lost by friction";
equation
  // Friction: Hagen and Poiseuille's law, steeper by Blasius's law beyond Re_0
  Re = smooth(0, noEvent(abs(m_flow)))*d/(A*rho*fluid.nu);
  dp_friction = 128*fluid.nu*l/(Constants.pi*d^4)*m_flow*(1 + (Re/Re_0)^8)^(0.75/8);
  // Inertia of the oil
  l/A*der(m_flow) = dp - dp_friction;
  annotation(Documentation(info = "<html>
<p>l/A dm_flow/dt = dp - dp_friction, dp_friction = 128 nu l m_flow (1 + (Re/Re_0)<sup>8</sup>)<sup>3/32</sup> /
(pi d<sup>4</sup>): friction factor 64/Re for Re much smaller than Re_0, 0.3164 Re<sup>-1/4</sup> (Blasius, 1913, smooth
walls, up to about 1e5) for much larger ones, joined smoothly. One state, the mass flow. Oil is stored in the volumes at
both ends, not in the pipe.</p>
</html>"));
end Pipe;
