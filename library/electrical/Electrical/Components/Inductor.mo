within Electrical.Components;
model Inductor "Constant inductance"
  extends Interfaces.PartialTwoPin(i(start = 0));
  parameter Units.Inductance L "Inductance";
equation
  // Faraday's law
  v = L*der(i);
  annotation(Documentation(info = "<html>
<p>v = L di/dt.</p>
</html>"));
end Inductor;
