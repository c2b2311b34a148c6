within Hydraulics.Functions;
function centrifugalForce "Axial force of oil that turns with a piston's chamber"
  input Mechanics.Units.AngularVelocity w "Speed of the chamber";
  input Mechanics.Units.Length r_o "Outer radius of the piston";
  input Mechanics.Units.Length r_i "Inner radius of the piston";
  input Mechanics.Units.Length r_p "Radius at which the oil enters";
  input Units.Density rho "Density";
  output Mechanics.Units.Force F "Force on the piston";
algorithm
  F := Constants.pi*rho*w^2/4*(r_o^4 - r_i^4 - 2*r_p^2*(r_o^2 - r_i^2));
  annotation(
    Inline = true,
    smoothOrder = 10,
    Documentation(info = "<html>
<p>The pressure rho w<sup>2</sup> (r<sup>2</sup> - r_p<sup>2</sup>)/2 of rigidly turning oil, integrated over the ring
from r_i to r_o.</p>
</html>"));
end centrifugalForce;
