within Electrical.Sources;
model SignalCurrent "Ideal current source"
  Interfaces.Pin p "Positive pin";
  Interfaces.Pin n "Negative pin";
  Signals.Interfaces.RealInput i(unit = "A") "Current out of p, through the circuit, into n";
equation
  p.i = -i;
  n.i = i;
  annotation(Documentation(info = "<html>
<p>The circuit receives the current i at p, whatever the voltage.</p>
</html>"));
end SignalCurrent;
