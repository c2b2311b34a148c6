within TenSpeed.Converter;
model TorusL5 "Level 5: map of torque ratio and capacity"
  extends PartialTorus;
  parameter Real ratio[:](each unit = "1") = {
    -1, -0.8, -0.6, -0.4, -0.2, 0, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4, 0.45, 0.5, 0.55, 0.6,
    0.65, 0.7, 0.75, 0.8, 0.85, 0.87, 0.88, 0.885, 0.89, 0.8925, 0.895, 0.8965, 0.8975, 0.9, 0.91,
    0.925, 0.94, 0.95, 0.96, 0.97, 0.975, 0.98, 0.984, 0.988, 0.99, 0.992, 0.994, 0.995, 0.996,
    0.998, 1}
    "Speed of the slower ring over that of the faster, rising";
  parameter Real capacity[size(ratio, 1)](each unit = "N.m.s2/rad2") = {
    0.0036245, 0.0037127, 0.00373152, 0.00369992, 0.00362246, 0.00349582, 0.00345545, 0.00341118,
    0.00336274, 0.00330982, 0.00325205, 0.00318901, 0.00312021, 0.00304505, 0.00296286, 0.00287279,
    0.00277382, 0.00266468, 0.00254376, 0.00240896, 0.0022574, 0.00208506, 0.0018858, 0.00179652,
    0.00174941, 0.00172518, 0.00170047, 0.00168793, 0.00167526, 0.00166759, 0.00165966, 0.00163973,
    0.00155828, 0.00143, 0.00129224, 0.00119319, 0.00108603, 0.000967025, 0.000900901, 0.000828102,
    0.000762769, 0.000687211, 0.000643098, 0.000591552, 0.000525183, 0.000477838, 2.76706e-07,
    1.65796e-07, 0}
    "Driving: torque into the impeller over its squared speed";
  parameter Real torqueRatio[size(ratio, 1)](each unit = "1") = {
    2.72345, 2.69771, 2.61173, 2.4819, 2.31817, 2.12741, 2.07609, 2.02345, 1.96953, 1.91438,
    1.85802, 1.80047, 1.74176, 1.68187, 1.62079, 1.55847, 1.49486, 1.42984, 1.36328, 1.29495,
    1.22453, 1.15154, 1.07519, 1.04343, 1.02724, 1.01905, 1.01081, 1.00666, 1.0025, 1, 1, 1, 1,
    0.999999, 0.999999, 0.999999, 0.999998, 0.999998, 0.999997, 0.999997, 0.999996, 0.999995,
    0.999995, 0.999994, 0.999993, 0.999991, 0.981246, 0.969266, 1}
    "Driving: torque out of the turbine over torque into the impeller";
  parameter Real capacityOverrun[size(ratio, 1)](each unit = "N.m.s2/rad2") = {
    2.81219e-06, 0.000847671, 0.00131398, 0.00152782, 0.00160512, 0.00158388, 0.00157999,
    0.00157054, 0.00155574, 0.00153572, 0.00151063, 0.00148052, 0.00144543, 0.0014053, 0.00136,
    0.00130926, 0.00125265, 0.00118954, 0.0011189, 0.00103922, 0.000948056, 0.000841414,
    0.000712091, 0.000651155, 0.00061804, 0.000600714, 0.000582825, 0.000573656, 0.000564329,
    0.000558655, 0.000554839, 0.000545178, 0.000504679, 0.000437331, 0.000359528, 0.000299636,
    0.000230679, 0.000148506, 0.000100122, 4.4481e-05, 1.69988e-06, 8.57141e-07, 6.43945e-07,
    4.71554e-07, 3.23294e-07, 2.5533e-07, 1.90455e-07, 6.7754e-08, 0}
    "Overrunning: torque into the turbine over its squared speed";
  parameter Real torqueRatioOverrun[size(ratio, 1)](each unit = "1") = {
    0.998227, 1.25774, 1.20279, 1.13859, 1.06995, 1, 1, 1, 1, 0.999999, 0.999999, 0.999999,
    0.999999, 0.999999, 0.999999, 0.999998, 0.999998, 0.999998, 0.999998, 0.999997, 0.999997,
    0.999996, 0.999995, 0.999995, 0.999994, 0.999994, 0.999994, 0.999994, 0.999993, 0.999993,
    0.999993, 0.999993, 0.999993, 0.999991, 0.999989, 0.999987, 0.999983, 0.999973, 0.99996,
    0.99991, 0.997604, 0.994961, 0.993106, 0.990338, 0.985553, 0.981487, 0.974889, 0.927792, 1}
    "Overrunning: torque out of the impeller over torque into the turbine";
  Mechanics.Units.AngularVelocity w_p(start = w_p_start, nominal = 100) "Speed of the impeller";
  Mechanics.Units.AngularVelocity w_t(start = w_t_start, nominal = 100) "Speed of the turbine";
  Mechanics.Units.Ratio x "Speed of the slower ring over that of the faster";
protected
  constant Mechanics.Units.AngularVelocity w_small = 1e-3 "Speed that counts as rest";
equation
  w_p = impeller.w;
  w_t = turbine.w;
  // The faster ring drives
  x = noEvent(if w_p >= w_t then w_t/max(w_p, w_small) else w_p/max(w_t, w_small));
  impeller.tau = noEvent(
    if w_p >= w_t then Functions.interpolate(x, ratio, capacity)*w_p*abs(w_p)
    else -Functions.interpolate(x, ratio, torqueRatioOverrun)*turbine.tau);
  turbine.tau = noEvent(
    if w_p >= w_t then -Functions.interpolate(x, ratio, torqueRatio)*impeller.tau
    else Functions.interpolate(x, ratio, capacityOverrun)*w_t*abs(w_t));
  annotation(Documentation(info = "<html>
<p>Driving: tau_p = capacity w_p<sup>2</sup>, tau_t = -torqueRatio tau_p; K = 30/pi / sqrt(capacity) in rpm/sqrt(N.m).
Overrunning, w_t &gt; w_p: the same from the turbine's side. Both meet at equal speeds without torque. Linear between the
points.</p>
<p>The defaults are the steady states of the default geometry, as <code>acausal.study.converter.steady_map</code>
computes them; it gives the arrays of any other geometry too. <code>geometry</code> has no effect here.</p>
</html>"));
end TorusL5;
