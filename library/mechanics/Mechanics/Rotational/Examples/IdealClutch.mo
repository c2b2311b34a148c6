within Mechanics.Rotational.Examples;
model IdealClutch "Two inertias with an engaged and two with an open clutch"
  parameter Boolean engaged = true "State of the first clutch" annotation(Evaluate = true);
  Sources.Torque drive(tau_start = 6) "Drive of the first pair";
  Components.Inertia left(J = 0.2) "First body";
  Components.IdealEngagement clutch(engaged = engaged) "Clutch under test";
  Components.Inertia right(J = 0.4) "Second body";
  output Units.AngularAcceleration error "Difference to the closed form";
equation
  connect(drive.flange, left.flange_a);
  connect(left.flange_b, clutch.flange_a);
  connect(clutch.flange_b, right.flange_a);
  // Closed form: tau / (J_1 + J_2) when engaged, tau / J_1 when open
  error = left.a - (if engaged then 10 else 30);
  annotation(
    experiment(StopTime = 1, Tolerance = 1e-6),
    Documentation(info = "<html>
<p>Engaged: a = tau / (J_1 + J_2), two states. Open: a = tau / J_1, four states.</p>
</html>"));
end IdealClutch;
