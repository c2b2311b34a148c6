within Electrical;
package Components "Resistor, inductor and what makes a solenoid"
  annotation(Documentation(info = "<html>
<p>Every component has a model in <code>Examples</code> that is also its test.</p>
</html>"));
end Components;
