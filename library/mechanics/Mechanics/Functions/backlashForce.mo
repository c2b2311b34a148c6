within Mechanics.Functions;
function backlashForce "Force between two partners with play, which touch on either side"
  input Units.Length delta "Relative displacement from the middle of the play";
  input Units.Velocity delta_dot "Rate of the relative displacement";
  input Units.Length b "Total play, from contact on one side to contact on the other";
  input Units.TranslationalSpringConstant c "Contact stiffness";
  input Units.TranslationalDampingConstant d "Contact damping";
  output Units.Force f "Force against the displacement: positive for positive contact";
algorithm
  f := elasticContact(delta - b/2, delta_dot, c, d) - elasticContact(-delta - b/2, -delta_dot, c, d);
  annotation(
    Inline = true,
    smoothOrder = 0,
    Documentation(info = "<html>
<p>f = contact(delta - b/2) - contact(-delta - b/2) with <code>elasticContact</code>: zero inside the play, odd in
(delta, ddelta/dt).</p>
</html>"));
end backlashForce;
