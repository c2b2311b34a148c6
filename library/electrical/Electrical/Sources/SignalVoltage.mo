within Electrical.Sources;
model SignalVoltage "Ideal voltage source"
  Interfaces.Pin p "Positive pin";
  Interfaces.Pin n "Negative pin";
  Signals.Interfaces.RealInput v(unit = "V") "Voltage from p to n";
equation
  p.v - n.v = v;
  p.i + n.i = 0;
  annotation(Documentation(info = "<html>
<p>v_p - v_n = v, whatever the current.</p>
</html>"));
end SignalVoltage;
