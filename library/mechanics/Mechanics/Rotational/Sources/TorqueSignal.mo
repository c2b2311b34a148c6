within Mechanics.Rotational.Sources;
model TorqueSignal "Torque from the case on a shaft, given by a signal"
  extends Interfaces.PartialOneFlange;
  Signals.Interfaces.RealInput tau(unit = "N.m") "Torque, positive drives the shaft forward";
equation
  flange.tau = -tau;
  annotation(Documentation(info = "<html>
<p>The shaft receives the torque of the signal.</p>
</html>"));
end TorqueSignal;
