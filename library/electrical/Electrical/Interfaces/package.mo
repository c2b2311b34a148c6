within Electrical;
package Interfaces "Connector and partial base classes"
  annotation(Documentation(info = "<html>
<p>The pin, and what components with two pins have in common.</p>
</html>"));
end Interfaces;
