within Hydraulics.Examples;
model PumpAndLaminarLoad "A pump turns at constant speed against a laminar load"
  Mechanics.Rotational.Sources.Speed drive(w_start = 0, w_end = 150, duration = 0.2) "Shaft";
  Sources.Tank tank "Tank";
  Components.Pump pump(D = 10e-6, leakage = 1e-12, d = 0.01) "Pump under test";
  Components.Volume line(n = 2, V_0 = 1e-4) "Line";
  Components.LaminarOrifice load(d = 3e-3, l = 0.5) "Load";
  Sources.Tank drain "Tank";
  output Real error(unit = "1") "Difference of the pressure to the closed form of an incompressible oil, relative, at rest";
protected
  final parameter Real conductance(unit = "m3/(s.Pa)") =
    Constants.pi*load.d^4/(128*load.fluid.rho_ref*load.fluid.nu*load.l) "Flow over pressure difference of the load";
equation
  connect(drive.flange, pump.flange);
  connect(tank.port, pump.port_a);
  connect(pump.port_b, line.port[1]);
  connect(line.port[2], load.port_a);
  connect(load.port_b, drain.port);
  error = pump.dp*(conductance + pump.leakage)/(pump.D*150/(2*Constants.pi)) - 1;
  annotation(
    experiment(StopTime = 1, Tolerance = 1e-8),
    Documentation(info = "<html>
<p>At rest D w / 2pi = dp (leakage + pi d<sup>4</sup> / (128 rho nu l)).</p>
</html>"));
end PumpAndLaminarLoad;
