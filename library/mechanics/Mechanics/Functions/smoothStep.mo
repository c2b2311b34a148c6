within Mechanics.Functions;
function smoothStep "Rise from 0 at u = 0 to 1 at u = 1, twice continuously differentiable"
  input Real u(unit = "1") "Progress of the rise";
  output Real y(unit = "1") "0 before, 1 after, a polynomial of degree five between";
protected
  Real v(unit = "1") "Progress within the rise";
algorithm
  v := max(0, min(1, u));
  y := smooth(2, noEvent(v^3*(10 + v*(6*v - 15))));
  annotation(
    Inline = true,
    smoothOrder = 2,
    Documentation(info = "<html>
<p>y = 6 u<sup>5</sup> - 15 u<sup>4</sup> + 10 u<sup>3</sup> for 0 &lt; u &lt; 1: the polynomial of lowest degree
whose value, slope and curvature join both constants. It makes no event.</p>
</html>"));
end smoothStep;
