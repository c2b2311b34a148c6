within Hydraulics.Examples;
model OrificeFlow "Orifice under a pressure difference that changes sign"
  Sources.PressureSource left(p_start = 1e5, p_end = 11e5, startTime = 0, duration = 1) "Rising pressure";
  Components.Orifice orifice(d = 1e-3) "Restriction";
  Sources.Tank right(p_tank = 6e5) "Constant pressure";
  output Units.MassFlowRate error "Difference to the turbulent law, small away from zero";
equation
  connect(left.port, orifice.port_a);
  connect(orifice.port_b, right.port);
  // Turbulent law
  error = orifice.m_flow
    - noEvent(sign(orifice.dp)*orifice.C_d*orifice.A*sqrt(2*orifice.rho*abs(orifice.dp)));
  annotation(
    experiment(StopTime = 1, Tolerance = 1e-6),
    Documentation(info = "<html>
<p>Away from dp = 0 the flow is C_d A sqrt(2 rho dp); at dp = 0 it passes with a finite slope.</p>
</html>"));
end OrificeFlow;
