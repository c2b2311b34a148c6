within Mechanics.Rotational.Sources;
model Acceleration "Constant acceleration from a given speed"
  extends Interfaces.PartialOneFlange;
  parameter Units.AngularAcceleration a "Acceleration";
  parameter Units.AngularVelocity w_0 = 0 "Speed at time 0";
  parameter Units.Angle phi_0 = 0 "Angle at time 0";
equation
  flange.phi = phi_0 + w_0*time + a*time^2/2;
  annotation(Documentation(info = "<html>
<p>phi = phi_0 + w_0 t + a t<sup>2</sup>/2, in closed form: no state.</p>
</html>"));
end Acceleration;
