within Hydraulics;
package Valves "Valves assembled from components"
  annotation(Documentation(info = "<html>
<p>Only connections of <code>Components</code>; no law of their own.</p>
</html>"));
end Valves;
