within Mechanics.Functions;
function frictionCoefficient "Friction coefficient of lubricated plates that slip"
  input Units.AngularVelocity w(min = 0) "Magnitude of the slip";
  input Units.Ratio mu_0 "Coefficient of sticking plates";
  input Units.Ratio K_1 "Coefficient once slip has built up";
  input Units.RotationalTime K_2 "Inverse of the slip over which the coefficient falls";
  input Units.RotationalTime K_3 "Viscous rise of the coefficient";
  output Units.Ratio mu "Friction coefficient";
algorithm
  mu := mu_0 - (mu_0 - K_1)*tanh(K_2*w) + K_3*w;
  annotation(
    Inline = true,
    smoothOrder = 10,
    Documentation(info = "<html>
<p>mu = mu_0 - (mu_0 - K_1) tanh(K_2 w) + K_3 w for w &ge; 0: mu_0 at rest, K_1 + K_3 w once tanh has saturated.</p>
</html>"));
end frictionCoefficient;
