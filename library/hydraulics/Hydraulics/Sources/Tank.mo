within Hydraulics.Sources;
model Tank "Reservoir at constant pressure"
  extends Interfaces.PartialSource;
  parameter Units.AbsolutePressure p_tank = Constants.p_atmosphere "Pressure of the reservoir";
equation
  // Unlimited reservoir
  port.p = p_tank;
  annotation(Documentation(info = "<html>
<p>p = p_tank, whatever the flow.</p>
</html>"));
end Tank;
