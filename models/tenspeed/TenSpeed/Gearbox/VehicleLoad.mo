within TenSpeed.Gearbox;
model VehicleLoad "The vehicle of the ten-speed transmission on its output shaft"
  extends Mechanics.Rotational.Components.VehicleLoad(
    M = 1900,
    R_tire = 0.33,
    Z_FD = 3.61,
    C_DA = 0.75,
    rho = 1.2);
  annotation(Documentation(info = "<html>
<p>A passenger car of 1,900 kg.</p>
</html>"));
end VehicleLoad;
