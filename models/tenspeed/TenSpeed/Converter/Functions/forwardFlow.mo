within TenSpeed.Converter.Functions;
function forwardFlow "Part of the flow that runs forward"
  input Hydraulics.Units.VolumeFlowRate Q "Flow";
  input Hydraulics.Units.VolumeFlowRate Q_0 "Flow within which both directions blend";
  output Hydraulics.Units.VolumeFlowRate q "Q for Q >= Q_0, 0 for Q <= -Q_0, positive between";
algorithm
  q := 2*Q_0*Mechanics.Functions.smoothStepIntegral((Q + Q_0)/(2*Q_0));
  annotation(
    Inline = true,
    smoothOrder = 3,
    Documentation(info = "<html>
<p>The integral of <code>forwardShare</code>: q = 2 Q_0 smoothStepIntegral((Q + Q_0) / (2 Q_0)). The part that runs
backward is q - Q, not negative either. At Q = 0 both are 0.16 Q_0: turbulence exchanges a little momentum between the
rings even when the mean flow rests, which determines the stator's speed.</p>
</html>"));
end forwardFlow;
