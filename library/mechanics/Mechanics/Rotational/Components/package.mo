within Mechanics.Rotational;
package Components "Inertias, springs, dampers, gears and ideal clutches"
  annotation(Documentation(info = "<html>
<p>Every component has a model in <code>Examples</code> that is also its test.</p>
</html>"));
end Components;
