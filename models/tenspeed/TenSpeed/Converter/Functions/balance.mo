within TenSpeed.Converter.Functions;
function balance "Net pressure with the stator at its steady speed"
  input Hydraulics.Units.VolumeFlowRate Q "Flow";
  input Mechanics.Units.AngularVelocity w_p "Speed of the impeller";
  input Mechanics.Units.AngularVelocity w_t "Speed of the turbine";
  input Geometry g "Circuit";
  output Hydraulics.Units.PressureDifference p "Net pressure";
algorithm
  p := netPressure(Q, w_p, w_t, smooth(0, noEvent(max(0, freeStatorSpeed(Q, w_p, w_t, g)))), g);
  annotation(
    Inline = true,
    smoothOrder = 0,
    Documentation(info = "<html>
<p><code>netPressure</code> at the larger of 0 and <code>freeStatorSpeed</code>.</p>
</html>"));
end balance;
