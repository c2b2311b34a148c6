package Electrical "Electric circuits as far as solenoids need them"
  annotation(
    version = "0.1.0",
    uses(Mechanics(version = "0.1.0"), Signals(version = "0.1.0")),
    Documentation(info = "<html>
<p>Pins with the variables of the Modelica Standard Library's, so components of both connect. A coil is resistance,
inductance and a converter between current and force.</p>
</html>"));
end Electrical;
