within Mechanics.Functions;
function backlashTorque "Torque between two shafts with play, which touch on either side"
  input Units.Angle phi "Relative angle from the middle of the play";
  input Units.AngularVelocity w "Relative speed";
  input Units.Angle b "Total play, from contact on one side to contact on the other";
  input Units.RotationalSpringConstant c "Stiffness in contact";
  input Units.RotationalDampingConstant d "Damping in contact";
  output Units.Torque tau "Torque against the relative angle: positive for positive contact";
protected
  Units.Angle forward "Wind-up of the contact at positive relative angle";
  Units.Angle backward "Wind-up of the contact at negative relative angle";
algorithm
  forward := phi - b/2;
  backward := -phi - b/2;
  tau := smooth(0, noEvent(
    if forward > 0 then c*forward + boundedDamping(d*w, c*forward)
    else if backward > 0 then -c*backward + boundedDamping(d*w, c*backward)
    else 0));
  annotation(
    Inline = true,
    smoothOrder = 0,
    Documentation(info = "<html>
<p>As <code>backlashForce</code>, for rotation: tau = c psi + <code>boundedDamping</code>(d w, c psi) with psi = phi -
b/2 in contact at positive angle, its mirror image at negative angle, zero between.</p>
</html>"));
end backlashTorque;
