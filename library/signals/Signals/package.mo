package Signals "Directed signals between components"
  annotation(
    version = "0.1.0",
    uses(Mechanics(version = "0.1.0")),
    Documentation(info = "<html>
<p>Connectors that carry one value in one direction, and sources of such values. The connectors have the types of the
Modelica Standard Library's, so blocks of both libraries can be connected.</p>
</html>"));
end Signals;
