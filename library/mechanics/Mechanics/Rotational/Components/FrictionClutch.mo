within Mechanics.Rotational.Components;
model FrictionClutch "Friction clutch with a choice of how its plates stick"
  extends Interfaces.PartialTwoFlanges;
  parameter Types.StickLaw law = Types.StickLaw.elastic "How the plates stick" annotation(Evaluate = true);
  parameter Integer N_f(min = 1) = 6 "Number of friction surfaces; chosen: three friction plates";
  parameter Units.Length d_o = 0.16 "Outer diameter of the friction surfaces; chosen: usual for passenger cars";
  parameter Units.Length d_i = 0.13 "Inner diameter of the friction surfaces; chosen: usual for passenger cars";
  parameter Units.Ratio mu_0 = 0.13 "Friction coefficient of sticking plates; chosen: paper lining in transmission oil";
  parameter Units.Ratio K_1 = 0.12 "Friction coefficient of slipping plates; chosen: paper lining in transmission oil";
  parameter Units.RotationalTime K_2 = 0.5 "Shape of the transition; chosen: complete at 4 rad/s";
  parameter Units.RotationalTime K_3 = 5e-6 "Viscous rise; chosen: reaches mu_0 at 2000 rad/s, above any shaft";
  parameter Units.Length thickness = 2e-3 "Thickness of the plates, for elastic stick";
  parameter Units.RotationalDampingConstant d = 100 "Damping of elastic stick; chosen: see ElasticClutch";
  parameter Units.AngularVelocity w_dead(min = 1e-12) = 0.01 "Half of Karnopp's dead zone; chosen: see KarnoppClutch";
  parameter Units.AngularVelocity w_0(min = 1e-9) = 0.1 "Slip of the smooth law; chosen: see SmoothClutch";
  Signals.Interfaces.RealInput f_normal(unit = "N") "Normal force; none where it is negative";
  Units.Torque tau "Torque into flange_b";
  Units.AngularVelocity w_rel "Speed of flange_b relative to flange_a";
  ElasticClutch elastic(
    final N_f = N_f, final d_o = d_o, final d_i = d_i, final mu_0 = mu_0, final K_1 = K_1, final K_2 = K_2,
    final K_3 = K_3, final thickness = thickness, final d = d) if law == Types.StickLaw.elastic "Elastic stick";
  RigidClutch rigid(
    final N_f = N_f, final d_o = d_o, final d_i = d_i, final mu_0 = mu_0, final K_1 = K_1, final K_2 = K_2,
    final K_3 = K_3) if law == Types.StickLaw.rigid "Rigid stick";
  KarnoppClutch karnopp(
    final N_f = N_f, final d_o = d_o, final d_i = d_i, final mu_0 = mu_0, final K_1 = K_1, final K_2 = K_2,
    final K_3 = K_3, final w_dead = w_dead) if law == Types.StickLaw.karnopp "Dead zone";
  SmoothClutch smoothLaw(
    final N_f = N_f, final d_o = d_o, final d_i = d_i, final mu_0 = mu_0, final K_1 = K_1, final K_2 = K_2,
    final K_3 = K_3, final w_0 = w_0) if law == Types.StickLaw.smooth "Never sticks";
equation
  connect(flange_a, elastic.flange_a);
  connect(flange_b, elastic.flange_b);
  connect(f_normal, elastic.f_normal);
  connect(flange_a, rigid.flange_a);
  connect(flange_b, rigid.flange_b);
  connect(f_normal, rigid.f_normal);
  connect(flange_a, karnopp.flange_a);
  connect(flange_b, karnopp.flange_b);
  connect(f_normal, karnopp.f_normal);
  connect(flange_a, smoothLaw.flange_a);
  connect(flange_b, smoothLaw.flange_b);
  connect(f_normal, smoothLaw.f_normal);
  // Observed
  tau = flange_b.tau;
  w_rel = der(flange_b.phi) - der(flange_a.phi);
  annotation(Documentation(info = "<html>
<p>One of four components stands between the flanges, as <code>law</code> says: <code>ElasticClutch</code>,
<code>RigidClutch</code>, <code>KarnoppClutch</code> or <code>SmoothClutch</code>. All have the same torque while they
slip.</p>
</html>"));
end FrictionClutch;
