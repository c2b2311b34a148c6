within Mechanics.Translational;
package Components "Masses, springs and dampers"
  annotation(Documentation(info = "<html>
<p>Every component has a model in <code>Examples</code> that is also its test.</p>
</html>"));
end Components;
