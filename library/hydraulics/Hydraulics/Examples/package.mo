within Hydraulics;
package Examples "One model per component, which is also its test"
  annotation(Documentation(info = "<html>
<p>Where a closed form or a conservation law exists, the output <code>error</code> is the difference to it.</p>
</html>"));
end Examples;
