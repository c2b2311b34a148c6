within Hydraulics.Components;
model SpringAccumulator "Accumulator with a piston on a preloaded spring, without mass"
  extends Interfaces.PartialVolume;
  parameter Units.Area A "Area of the piston";
  parameter Mechanics.Units.TranslationalSpringConstant c "Stiffness of the spring";
  parameter Mechanics.Units.Force F_preload "Force of the spring at position 0";
  parameter Mechanics.Units.Length s_max "Stroke";
  parameter Units.Volume V_dead(min = 1e-12) "Oil at position 0";
  parameter Mechanics.Units.TranslationalSpringConstant c_stop = 1e4*c "Stiffness of the end stops; chosen: hard";
  parameter Units.AbsolutePressure p_behind = Constants.p_atmosphere "Pressure on the spring's side";
  Interfaces.Port port "Port";
  Mechanics.Units.Position s "Position of the piston, positive compresses the spring";
protected
  Mechanics.Units.Force f "Force of the oil beyond the preload";
equation
  // Balance of forces: end stop, spring, spring and end stop
  f = A*(p - p_behind) - F_preload;
  s = smooth(0, noEvent(if f < 0 then f/(c + c_stop) elseif f > c*s_max then s_max + (f - c*s_max)/(c + c_stop) else f/c));
  // Displacement
  V = V_dead + A*s;
  V_flow = A^2*der(p)*noEvent(if f < 0 or f > c*s_max then 1/(c + c_stop) else 1/c);
  // Flow through the port
  port.p = p;
  m_flow = rho*port.q;
  annotation(Documentation(info = "<html>
<p>A (p - p_behind) = F_preload + c s between the end stops, which are elastic. One state, the pressure.</p>
</html>"));
end SpringAccumulator;
