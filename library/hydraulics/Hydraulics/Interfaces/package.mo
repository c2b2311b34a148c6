within Hydraulics;
package Interfaces "Connector and partial base classes"
  annotation(Documentation(info = "<html>
<p>The port, and what volumes and restrictions have in common.</p>
</html>"));
end Interfaces;
