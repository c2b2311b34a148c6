within Mechanics.Functions;
function elasticContact "Force of a contact with linear spring and damper that never pulls and never jumps"
  input Units.Length delta "Penetration, positive in contact";
  input Units.Velocity delta_dot "Rate of penetration";
  input Units.TranslationalSpringConstant c "Contact stiffness";
  input Units.TranslationalDampingConstant d "Contact damping at full penetration";
  input Units.Length depth "Penetration over which the damping builds up";
  output Units.Force f "Force that pushes the partners apart";
protected
  Real share(unit = "1") "Share of the damping";
algorithm
  share := smoothStep(delta/depth);
  f := smooth(0, noEvent(if delta > 0 then max(0, c*delta + share*d*delta_dot) else 0));
  annotation(
    Inline = true,
    smoothOrder = 0,
    Documentation(info = "<html>
<p>f = max(0, c delta + d smoothStep(delta / depth) ddelta/dt) for delta &gt; 0, else 0. The damping builds up over
<code>depth</code>, so the force is continuous when the contact opens and closes, and no event is needed.</p>
</html>"));
end elasticContact;
