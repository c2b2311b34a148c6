within Hydraulics.Interfaces;
partial model PartialVolume "Compressible oil at one pressure"
  replaceable package Oil = Media.OilDexronVI constrainedby Media.PartialOil "Oil whose data are the default"
    annotation(choicesAllMatching = true);
  parameter Media.Fluid fluid = Oil.data "Oil";
  parameter Units.AbsolutePressure p_start = Constants.p_atmosphere "Proposed initial pressure";
  Units.AbsolutePressure p(start = p_start, stateSelect = StateSelect.prefer) "Pressure";
  Units.Density rho "Density";
  Units.BulkModulus K "Effective bulk modulus";
  Units.Volume V "Volume";
  Units.VolumeFlowRate V_flow "Rate at which the walls enlarge the volume";
  Mechanics.Units.Mass m "Mass of oil and air";
  Units.MassFlowRate m_flow "Mass flow into the volume";
equation
  // Compressibility of oil with air
  rho = Media.density(p, fluid);
  K = Media.bulkModulus(p, fluid);
  m = rho*V;
  // Conservation of mass, d(rho V)/dt = m_flow with drho/dp = rho/K
  rho*(V/K*der(p) + V_flow) = m_flow;
  annotation(Documentation(info = "<html>
<p>d(rho(p) V)/dt = m_flow, written out with drho/dp = rho/K(p), which K fulfils exactly, so that the pressure is the
variable whose derivative appears: it is the state, unless a source prescribes it. The extending model gives V, its
rate V_flow, m_flow and the ports.</p>
</html>"));
end PartialVolume;
