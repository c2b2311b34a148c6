within Electrical.Interfaces;
partial model PartialTwoPin "Component with two pins and no storage of charge"
  Pin p "Positive pin";
  Pin n "Negative pin";
  Units.Voltage v "Voltage from p to n";
  Units.Current i "Current from p to n";
equation
  // Kirchhoff's laws
  v = p.v - n.v;
  p.i = i;
  n.i = -i;
  annotation(Documentation(info = "<html>
<p>v = v_p - v_n; i_p = i = -i_n. The extending model gives the law between v and i.</p>
</html>"));
end PartialTwoPin;
