within Mechanics.Functions;
function contactForce "Force of an elastic, damped contact that never pulls"
  input Units.Length delta "Penetration, positive in contact";
  input Units.Velocity delta_dot "Rate of penetration";
  input Units.TranslationalSpringConstant c "Contact stiffness";
  input Units.ContactDampingConstant b "Contact damping";
  output Units.Force f "Force that pushes the partners apart";
algorithm
  f := smooth(0, noEvent(if delta > 0 and 1 + b*delta_dot > 0 then c*delta*(1 + b*delta_dot) else 0));
  annotation(
    Inline = true,
    smoothOrder = 0,
    Documentation(info = "<html>
<p>f = c delta (1 + b ddelta/dt) for delta &gt; 0, never negative. The damping grows with the penetration, so the
force is continuous when the contact opens and closes, and no event is needed.</p>
<p>Source: K. H. Hunt and F. R. E. Crossley, Coefficient of restitution interpreted as damping in vibroimpact,
Journal of Applied Mechanics 42 (1975), 440-445, with a linear spring.</p>
</html>"));
end contactForce;
