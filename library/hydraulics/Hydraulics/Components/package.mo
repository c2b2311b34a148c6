within Hydraulics;
package Components "Volumes, restrictions and parts of spool valves"
  annotation(Documentation(info = "<html>
<p>Every component has a model in <code>Examples</code> that is also its test.</p>
</html>"));
end Components;
