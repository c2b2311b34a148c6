within Hydraulics.Components;
model Volume "Rigid volume of compressible oil with any number of ports"
  extends Interfaces.PartialVolume;
  parameter Integer n(min = 1) = 2 "Number of ports";
  parameter Units.Volume V_0 "Volume";
  Interfaces.Port port[n] "Ports, all at the pressure of the volume";
equation
  // Rigid walls
  V = V_0;
  V_flow = 0;
  // One pressure everywhere
  for i in 1:n loop
    port[i].p = p;
  end for;
  // Flow through all ports
  m_flow = rho*sum(port.q);
  annotation(Documentation(info = "<html>
<p>d(rho(p) V_0)/dt = rho sum(q<sub>i</sub>), hence dp/dt = K(p) / V_0 sum(q<sub>i</sub>). An unconnected port is
closed.</p>
</html>"));
end Volume;
