within TenSpeed.Converter.Functions;
function forwardShare "Share of the laws of forward flow"
  input Hydraulics.Units.VolumeFlowRate Q "Flow";
  input Hydraulics.Units.VolumeFlowRate Q_0 "Flow within which both directions blend";
  output Mechanics.Units.Ratio y "1 for Q >= Q_0, 0 for Q <= -Q_0";
algorithm
  y := Mechanics.Functions.smoothStep((Q + Q_0)/(2*Q_0));
  annotation(
    Inline = true,
    smoothOrder = 2,
    Documentation(info = "<html>
<p>y = smoothStep((Q + Q_0) / (2 Q_0)).</p>
</html>"));
end forwardShare;
