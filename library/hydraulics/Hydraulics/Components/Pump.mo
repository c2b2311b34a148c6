within Hydraulics.Components;
model Pump "Displacement pump with internal leakage and friction; a motor when driven by the oil"
  extends Interfaces.PartialPump;
equation
  displacement = D;
  annotation(Documentation(info = "<html>
<p>Fixed displacement D per revolution; laws: <code>Interfaces.PartialPump</code>.</p>
</html>"));
end Pump;
