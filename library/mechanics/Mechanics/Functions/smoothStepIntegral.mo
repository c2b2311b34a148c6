within Mechanics.Functions;
function smoothStepIntegral "Integral of smoothStep from 0 to u, three times continuously differentiable"
  input Real u(unit = "1") "Progress of the rise";
  output Real y(unit = "1") "0 before the rise, u - 1/2 after it";
algorithm
  y := smooth(3, noEvent(if u <= 0 then 0 else if u >= 1 then u - 0.5 else u^4*(2.5 + u*(u - 3))));
  annotation(
    Inline = true,
    smoothOrder = 3,
    Documentation(info = "<html>
<p>y = u<sup>6</sup> - 3 u<sup>5</sup> + 5/2 u<sup>4</sup> for 0 &lt; u &lt; 1. With it, a speed that rises smoothly is
prescribed as an angle, and no integrator is needed in the source.</p>
</html>"));
end smoothStepIntegral;
