within Hydraulics.Functions;
function positivePart "Smooth positive part of a length, never zero"
  input Mechanics.Units.Length x "Length";
  input Mechanics.Units.Length x_0 "Value at x = 0";
  output Mechanics.Units.Length y "About x where x is much larger than x_0, about x_0^2 / |x| where x is negative";
algorithm
  y := (x + sqrt(x^2 + 4*x_0^2))/2;
  annotation(
    Inline = true,
    smoothOrder = 10,
    Documentation(info = "<html>
<p>y = (x + sqrt(x<sup>2</sup> + 4 x_0<sup>2</sup>)) / 2, the positive root of
y<sup>2</sup> - x y - x_0<sup>2</sup> = 0. As the gap of a metering edge with radial clearance x_0 it gives the
clearance at the edge itself and a leakage that falls with the length of the covered land.</p>
</html>"));
end positivePart;
