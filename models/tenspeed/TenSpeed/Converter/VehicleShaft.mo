within TenSpeed.Converter;
model VehicleShaft "Vehicle in a fixed gear, seen at the turbine: mass, drag and brakes"
  parameter Mechanics.Units.Mass M = 1900 "Mass of the vehicle";
  parameter Mechanics.Units.Length R_tire = 0.33 "Radius of the tires";
  parameter Mechanics.Units.Ratio Z = 3.61*1.304 "Ratio of gearbox and final drive; default: fifth gear";
  parameter Mechanics.Units.Area C_DA = 0.75 "Drag coefficient times frontal area";
  parameter Mechanics.Units.Density rho = 1.2 "Density of air";
  parameter Mechanics.Units.AngularVelocity w_brake = 1 "Speed at which three quarters of the brake act; chosen: walking";
  Shaft shaft "Turbine shaft";
  Signals.Interfaces.RealInput brake(unit = "N.m") "Torque of the brakes at the turbine shaft";
  Mechanics.Units.AngularVelocity w(start = 0, nominal = 100) "Speed of the turbine shaft";
equation
  w = shaft.w;
  // Newton's law
  M*(R_tire/Z)^2*der(w) = shaft.tau - 0.5*rho*C_DA*(R_tire/Z)^3*w*noEvent(abs(w)) - brake*tanh(w/w_brake);
  annotation(Documentation(info = "<html>
<p>M (R/Z)<sup>2</sup> dw/dt = tau - 1/2 rho C_D A (R/Z)<sup>3</sup> w |w| - brake tanh(w / w_brake).</p>
</html>"));
end VehicleShaft;
