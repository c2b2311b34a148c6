within TenSpeed.Converter;
model SteadyFlow "Flow at which the net pressure vanishes, with the stator at its steady speed"
  parameter Geometry geometry "Circuit";
  input Mechanics.Units.AngularVelocity w_p "Speed of the impeller";
  input Mechanics.Units.AngularVelocity w_t "Speed of the turbine";
  Hydraulics.Units.VolumeFlowRate Q "Flow";
  Boolean high(start = true, fixed = true) "Whether Q is the largest stable solution, else it is the smallest";
protected
  constant Integer n = 12 "Grid points in either direction";
  constant Integer bisections = 14 "Bisections of the interval between two grid points";
  constant Integer corrections = 3 "Newton steps after them";
  constant Mechanics.Units.Ratio share = 0.02 "Largest flow of the lower solution over the largest flow of the grid";
  Hydraulics.Units.VolumeFlowRate Q_max(start = 0.2, nominal = 0.1) "Flow that is larger than any solution";
  Hydraulics.Units.VolumeFlowRate grid[2*n + 1] "Grid, denser at small flows";
  Hydraulics.Units.PressureDifference p[2*n + 1] "Net pressure on the grid";
  Mechanics.Units.Ratio falls[2*n] "1 where the net pressure falls through zero between two points: a stable solution";
  Hydraulics.Units.VolumeFlowRate up[2*n + 1] "Lower end of the last interval found on the way up";
  Hydraulics.Units.VolumeFlowRate down[2*n + 1] "Lower end of the last interval found on the way down";
  Hydraulics.Units.VolumeFlowRate upEnd[2*n + 1] "Upper end of the last interval found on the way up";
  Hydraulics.Units.VolumeFlowRate downEnd[2*n + 1] "Upper end of the last interval found on the way down";
  Hydraulics.Units.VolumeFlowRate left[bisections + 1] "Left end of the interval";
  Hydraulics.Units.VolumeFlowRate right[bisections + 1] "Right end of the interval";
  Hydraulics.Units.VolumeFlowRate Q_i[corrections + 1] "Flow before each Newton step";
  Hydraulics.Units.VolumeFlowRate h "Half the distance of the difference that gives the slope";
equation
  // Grid
  Q_max = geometry.A*geometry.R_p*sqrt(w_p^2 + w_t^2 + w_small^2) + 10*geometry.Q_0;
  grid = {Q_max*(k/n)^3 for k in -n:n};
  for k in 1:2*n + 1 loop
    p[k] = Functions.balance(grid[k], w_p, w_t, geometry);
  end for;
  // Stable solutions: the first and the last
  up[1] = grid[1];
  upEnd[1] = grid[2*n + 1];
  down[2*n + 1] = grid[1];
  downEnd[2*n + 1] = grid[2*n + 1];
  for k in 1:2*n loop
    falls[k] = noEvent(if p[k] > 0 and not p[k + 1] > 0 then 1 else 0);
    up[k + 1] = noEvent(if falls[k] > 0.5 then grid[k] else up[k]);
    upEnd[k + 1] = noEvent(if falls[k] > 0.5 then grid[k + 1] else upEnd[k]);
    down[k] = noEvent(if falls[k] > 0.5 then grid[k] else down[k + 1]);
    downEnd[k] = noEvent(if falls[k] > 0.5 then grid[k + 1] else downEnd[k + 1]);
  end for;
  // Bisection
  left[1] = if pre(high) then up[2*n + 1] else down[1];
  right[1] = if pre(high) then upEnd[2*n + 1] else downEnd[1];
  for i in 1:bisections loop
    left[i + 1] = noEvent(
      if Functions.balance((left[i] + right[i])/2, w_p, w_t, geometry) > 0 then (left[i] + right[i])/2 else left[i]);
    right[i + 1] = left[i + 1] + (right[i] - left[i])/2;
  end for;
  // Newton's method
  h = 1e-7*Q_max;
  Q_i[1] = (left[bisections + 1] + right[bisections + 1])/2;
  for i in 1:corrections loop
    Q_i[i + 1] = Q_i[i] - Functions.balance(Q_i[i], w_p, w_t, geometry)*2*h/noEvent(min(-p_small,
      Functions.balance(Q_i[i] + h, w_p, w_t, geometry)
      - Functions.balance(Q_i[i] - h, w_p, w_t, geometry)));
  end for;
  Q = Q_i[corrections + 1];
  // Between speed ratios of about 0.98 and 1 there are two: the branch is kept until it ends
  high = Q > share*Q_max;
protected
  constant Hydraulics.Units.PressureDifference p_small = 1e-12 "Keeps the slope away from zero";
  constant Mechanics.Units.AngularVelocity w_small = 0.1 "Keeps the root differentiable at rest";
  annotation(Documentation(info = "<html>
<p>The net pressure is evaluated on a grid; where it falls through zero there is a stable solution. Fourteen bisections
and three Newton steps find it to rounding. Among several the one is kept that the history led to: <code>high</code> is
discrete, and changes where its branch ends. The start is on the branch that continues from lower speed ratios.</p>
<p>All of it are explicit assignments: there is no iteration that could fail.</p>
</html>"));
end SteadyFlow;
