within Mechanics.Functions;
function backlashEnergy "Elastic energy between two partners with play"
  input Units.Length delta "Relative displacement from the middle of the play";
  input Units.Length b "Total play, from contact on one side to contact on the other";
  input Units.TranslationalSpringConstant c "Contact stiffness";
  output Units.Energy E "Energy of the contact's spring";
algorithm
  E := smooth(1, noEvent(c/2*max(0, abs(delta) - b/2)^2));
  annotation(
    Inline = true,
    smoothOrder = 1,
    Documentation(info = "<html>
<p>E = c/2 max(0, |delta| - b/2)<sup>2</sup>: the work of <code>backlashForce</code> without damping.</p>
</html>"));
end backlashEnergy;
