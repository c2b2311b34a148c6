within Hydraulics.Examples;
model ChamberDrivesSpool "Pressure behind an orifice moves a spool against its spring"
  Sources.PressureSource supply(p_start = 2e5, p_end = 10e5, startTime = 0.01, duration = 0.05) "Supply";
  Components.Orifice orifice(d = 1e-3) "Feed";
  Components.SpoolChamber chamber(A = 50e-6, V_0 = 2e-6) "Chamber under test";
  Components.Spool spool(
    m = 0.02,
    c = 10e3,
    F_preload = 10,
    s_max = 10e-3) "Spool";
  output Units.VolumeFlowRate error "Difference of flow and displacement plus compression";
equation
  connect(supply.port, orifice.port_a);
  connect(orifice.port_b, chamber.port);
  connect(chamber.flange, spool.flange);
  // Flow into the chamber: displacement and compression
  error = chamber.port.q - chamber.A*spool.v
    - chamber.V/Media.bulkModulus(chamber.p, chamber.fluid)*der(chamber.p);
  annotation(
    experiment(StopTime = 0.2, Tolerance = 1e-8),
    Documentation(info = "<html>
<p>q = A v + V / K dp/dt. At rest A (p - p_behind) = F_preload + c s.</p>
</html>"));
end ChamberDrivesSpool;
