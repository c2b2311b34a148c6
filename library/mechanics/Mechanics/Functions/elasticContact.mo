within Mechanics.Functions;
function elasticContact "Force of a contact with spring and damper that never pulls and never jumps"
  input Units.Length delta "Penetration, positive in contact";
  input Units.Velocity delta_dot "Rate of penetration";
  input Units.TranslationalSpringConstant c "Contact stiffness";
  input Units.TranslationalDampingConstant d "Contact damping";
  output Units.Force f "Force that pushes the partners apart";
algorithm
  f := smooth(0, noEvent(if delta > 0 then c*delta + boundedDamping(d*delta_dot, c*delta) else 0));
  annotation(
    Inline = true,
    smoothOrder = 0,
    Documentation(info = "<html>
<p>f = c delta + g / (1 + (g / (c delta))<sup>2</sup>) with g = d ddelta/dt for delta &gt; 0, else 0: a linear spring
and damper while the damper's force is small against the spring's, and <code>boundedDamping</code> where the contact
opens and closes. The force is continuous and no event is needed. Impacts lose the same share of their energy
whatever their speed, so that rattle dies away.</p>
</html>"));
end elasticContact;
