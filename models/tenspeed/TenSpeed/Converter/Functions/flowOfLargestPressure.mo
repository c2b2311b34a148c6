within TenSpeed.Converter.Functions;
function flowOfLargestPressure "Forward flow at which the net pressure is largest while the stator is free"
  input Mechanics.Units.AngularVelocity w_p "Speed of the impeller";
  input Mechanics.Units.AngularVelocity w_t "Speed of the turbine";
  input Geometry g "Circuit";
  output Hydraulics.Units.VolumeFlowRate Q "Flow; 0 or negative where the net pressure falls with every forward flow";
protected
  constant Real unit(final unit = "m/s") = 1 "Meridional velocity of one step";
  Real e[3](each unit = "m2/s2") "Net energy per mass at no flow, one and two steps of flow";
  Real w_s[3](each unit = "rad/s") "Speed of the free stator at these flows, without drag";
  Real curvature(unit = "m2/s2") "Half the second difference of the energy, counted downward";
  Real slope(unit = "m2/s2") "Slope at no flow, per step";
algorithm
  for k in 1:3 loop
    w_s[k] := (w_t*g.R_t^2 + (k - 1)*unit*(g.R_t*tan(g.a_t) - g.R_s*tan(g.a_s)))/g.R_s^2;
    e[k] := {w_p, w_t, w_s[k]}*momentum(true, (k - 1)*unit*g.A, w_p, w_t, w_s[k], g)
      - lossPressure(true, (k - 1)*unit*g.A, w_p, w_t, w_s[k], g);
  end for;
  curvature := -(e[3] - 2*e[2] + e[1])/2;
  slope := e[2] - e[1] + curvature;
  Q := g.A*unit*slope/(2*curvature);
  annotation(
    Inline = true,
    smoothOrder = 10,
    Documentation(info = "<html>
<p>The speed of a free stator is linear in the flow, so the net pressure of forward flow is a parabola in it. Three points
give its vertex: e(u) = e_0 + b u - c u<sup>2</sup> has its largest value at u = b / (2 c), with c the curvature, which the
losses keep positive.</p>
</html>"));
end flowOfLargestPressure;
