within Mechanics.Functions;
function smoothStep "Rise from 0 at u = 0 to 1 at u = 1, twice continuously differentiable"
  input Real u(unit = "1") "Progress of the rise";
  output Real y(unit = "1") "0 before, 1 after, a polynomial of degree five between";
algorithm
  y := smooth(2, noEvent(if u <= 0 then 0 else if u >= 1 then 1 else u^3*(10 + u*(6*u - 15))));
  annotation(
    Inline = true,
    smoothOrder = 2,
    Documentation(info = "<html>
<p>y = 6 u<sup>5</sup> - 15 u<sup>4</sup> + 10 u<sup>3</sup> for 0 &lt; u &lt; 1: the polynomial of lowest degree
whose value, slope and curvature join both constants. It makes no event.</p>
</html>"));
end smoothStep;
