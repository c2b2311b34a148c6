within TenSpeed.Converter;
model SteadyFlow "Flow at which the net pressure vanishes, with the stator at its steady speed"
  parameter Geometry geometry "Circuit";
  input Mechanics.Units.AngularVelocity w_p "Speed of the impeller";
  input Mechanics.Units.AngularVelocity w_t "Speed of the turbine";
  Hydraulics.Units.VolumeFlowRate Q "Flow";
  Boolean high(start = true, fixed = true) "Whether Q is the largest solution, else it is the smallest";
protected
  constant Integer bisections = 15 "Bisections of the interval that has one solution";
  constant Integer corrections = 3 "Newton steps after them";
  constant Mechanics.Units.Ratio margin = 0.01
    "Part of the depth between both branches at which one is left before it ends; chosen: a tenth of the flow's range";
  Hydraulics.Units.VolumeFlowRate Q_max(start = 0.2, nominal = 0.1) "Flow that is larger than any solution";
  Hydraulics.Units.VolumeFlowRate Q_m(start = 0.01, nominal = 0.01) "Forward flow of the largest net pressure";
  Hydraulics.Units.PressureDifference p_m "Net pressure there";
  Hydraulics.Units.PressureDifference p_0 "Net pressure where the blending of both directions ends";
  Hydraulics.Units.PressureDifference depth "How far the net pressure falls from the upper branch's end to the lower's";
  Hydraulics.Units.PressureDifference rest "Negative where the present branch is left";
  Boolean leaves "Whether it is";
  discrete Mechanics.Units.Time t_left(start = -1e60, fixed = true) "When a branch was left last";
  Integer returns(start = 0, fixed = true) "How often the other branch was left in the same instant";
  Hydraulics.Units.VolumeFlowRate least "Left end of the lower branch's interval";
  Hydraulics.Units.VolumeFlowRate left "Left end of the interval with one stable solution";
  Hydraulics.Units.VolumeFlowRate right "Right end of this interval";
  Hydraulics.Units.VolumeFlowRate middle[bisections + 1] "Middle of what is left of it after each bisection";
  Hydraulics.Units.VolumeFlowRate half "Half the length of what is left at the end";
  Hydraulics.Units.VolumeFlowRate Q_i[corrections + 1] "Flow before each Newton step";
  Hydraulics.Units.VolumeFlowRate h "Half the distance of the difference that gives the slope";
equation
  // Between the branches the net pressure rises: from the end of the blending to the largest forward pressure
  Q_max = geometry.A*geometry.R_p*sqrt(w_p^2 + w_t^2 + w_small^2) + 10*geometry.Q_0;
  Q_m = noEvent(max(geometry.Q_0, Functions.flowOfLargestPressure(w_p, w_t, geometry)));
  p_m = Functions.balance(Q_m, w_p, w_t, geometry);
  p_0 = Functions.balance(geometry.Q_0, w_p, w_t, geometry);
  depth = noEvent(max(0, p_m - p_0));
  // The branch is kept until shortly before it ends
  rest = if pre(high) then p_0 + (1 - margin)*depth else -p_0 - margin*depth;
  leaves = rest < 0;
  high = if pre(returns) > 2 then pre(high) else pre(high) <> leaves;
  when {high, not high} then
    returns = if time > pre(t_left) then 0 else pre(returns) + 1;
    t_left = time;
  end when;
  assert(returns < 3, "no stable steady flow carries these torques: only the middle branch does; levels 1 and 3 follow it,"
    + " acausal.study.converter.steady_state computes it");
  // Bisection of an interval with one stable solution; beyond its branch's end Q stays at the interval's
  least = noEvent(if Functions.balance(-geometry.Q_0, w_p, w_t, geometry) > 0 then -geometry.Q_0 else -Q_max);
  left = if pre(high) then noEvent(if p_m > p_0 then Q_m else geometry.Q_0) else least;
  right = if pre(high) then Q_max else geometry.Q_0;
  middle[1] = (left + right)/2;
  for i in 1:bisections loop
    middle[i + 1] = middle[i] + noEvent(
      if Functions.balance(middle[i], w_p, w_t, geometry) > 0 then right - left else left - right)/2^(i + 1);
  end for;
  half = (right - left)/2^(bisections + 1);
  // Newton's method
  h = 1e-7*Q_max;
  Q_i[1] = middle[bisections + 1];
  for i in 1:corrections loop
    Q_i[i + 1] = noEvent(max(Q_i[1] - half, min(Q_i[1] + half,
      Q_i[i] - Functions.balance(Q_i[i], w_p, w_t, geometry)*2*h/min(-p_small,
        Functions.balance(Q_i[i] + h, w_p, w_t, geometry)
        - Functions.balance(Q_i[i] - h, w_p, w_t, geometry)))));
  end for;
  Q = Q_i[corrections + 1];
protected
  constant Hydraulics.Units.PressureDifference p_small = 1e-12 "Keeps the slope away from zero";
  constant Mechanics.Units.AngularVelocity w_small = 0.1 "Keeps the root differentiable at rest";
  annotation(Documentation(info = "<html>
<p>Up to the flow Q_0 the net pressure falls, then it rises to that of Q_m, beyond which it falls again: there is one
solution below Q_0 (the lower branch: nearly no flow, and reverse flow) or one above Q_m (the upper branch), or both.
Bisection of the one interval or the other and three Newton steps find it to rounding.</p>
<p>Where both exist the one is kept that the history led to: <code>high</code> is discrete, and changes, by an event,
shortly before its branch ends, while the flow is still a smooth function of the speeds. Beyond the end the flow stays
at that of the end, so that a step of a solver that looks beyond the event finds no jump. The start is on the branch that
continues from lower speed ratios.</p>
<p>All of it are explicit assignments: there is no iteration that could fail. It holds for a turbine that turns backward
with up to 0.6 of the impeller's speed, as well; beyond, a third solution with the turbine as pump exists.</p>
</html>"));
end SteadyFlow;
