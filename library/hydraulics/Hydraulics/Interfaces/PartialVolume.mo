within Hydraulics.Interfaces;
partial model PartialVolume "Compressible oil at one pressure"
  parameter Media.DexronVI fluid "Oil";
  parameter Units.AbsolutePressure p_start = Constants.p_atmosphere "Proposed initial pressure";
  Units.AbsolutePressure p(start = p_start, stateSelect = StateSelect.prefer) "Pressure";
  Units.Density rho "Density";
  Units.Volume V "Volume";
  Mechanics.Units.Mass m(stateSelect = StateSelect.avoid) "Mass of oil and air";
  Units.MassFlowRate m_flow "Mass flow into the volume";
equation
  // Compressibility of oil with air
  rho = Media.density(p, fluid);
  m = rho*V;
  // Conservation of mass
  der(m) = m_flow;
  annotation(Documentation(info = "<html>
<p>d(rho(p) V)/dt = m_flow. The extending model gives V and m_flow and its ports. The pressure is preferred as the
state; a source may prescribe it instead.</p>
</html>"));
end PartialVolume;
