within Mechanics.Translational;
package Interfaces "Connector and partial base classes"
  annotation(Documentation(info = "<html>
<p>The flange, and what components with one or two flanges have in common.</p>
</html>"));
end Interfaces;
