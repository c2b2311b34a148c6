within Hydraulics.Functions;
function interpolate "Piecewise linear curve, constant outside"
  input Real u "Where";
  input Real x[:] "Points, rising";
  input Real y[size(x, 1)] "Values at the points";
  output Real v "Value at u";
algorithm
  v := y[1] + sum({(y[k + 1] - y[k])*smooth(0, noEvent(max(0, min(1, (u - x[k])/(x[k + 1] - x[k])))))
    for k in 1:size(x, 1) - 1});
  annotation(
    Inline = true,
    smoothOrder = 0,
    Documentation(info = "<html>
<p>v = y[1] + &sum; (y[k+1] - y[k]) clip((u - x[k]) / (x[k+1] - x[k])), clipped to 0 and 1. It makes no event.</p>
</html>"));
end interpolate;
