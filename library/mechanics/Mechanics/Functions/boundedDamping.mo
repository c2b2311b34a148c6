within Mechanics.Functions;
function boundedDamping "Damping of a contact, at most half of its elastic force"
  input Real viscous "Force or torque that a linear damper would have";
  input Real elastic "Elastic force or torque, positive";
  output Real y "Damping force or torque";
algorithm
  y := viscous/(1 + (viscous/elastic)^2);
  annotation(
    Inline = true,
    smoothOrder = 2,
    Documentation(info = "<html>
<p>y = g / (1 + (g / e)<sup>2</sup>) for the linear damper's force g and the elastic force e &gt; 0. It is g to second
order in g / e, never more than e / 2 and falls to zero with e, so that elastic and damping force together are never
negative and vanish where the contact opens. It is homogeneous in (e, g): an impact of half the speed is the same
impact at half the scale.</p>
</html>"));
end boundedDamping;
