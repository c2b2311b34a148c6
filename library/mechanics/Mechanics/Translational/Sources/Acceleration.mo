within Mechanics.Translational.Sources;
model Acceleration "Constant acceleration from a given speed"
  extends Interfaces.PartialOneFlange;
  parameter Units.Acceleration a "Acceleration";
  parameter Units.Velocity v_0 = 0 "Speed at time 0";
  parameter Units.Position s_0 = 0 "Position at time 0";
equation
  flange.s = s_0 + v_0*time + a*time^2/2;
  annotation(Documentation(info = "<html>
<p>s = s_0 + v_0 t + a t<sup>2</sup>/2, in closed form: no state.</p>
</html>"));
end Acceleration;
