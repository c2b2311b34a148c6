within Hydraulics.Examples;
model MineralOilProperties "Density and bulk modulus over pressure are consistent for another oil"
  extends FluidProperties(fluid = Media.MineralVG32());
  annotation(
    experiment(StopTime = 1, Tolerance = 1e-8),
    Documentation(info = "<html>
<p>drho/dt = rho / K dp/dt must hold exactly.</p>
</html>"));
end MineralOilProperties;
