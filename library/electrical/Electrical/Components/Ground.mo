within Electrical.Components;
model Ground "Potential zero"
  Interfaces.Pin p "Pin";
equation
  p.v = 0;
  annotation(Documentation(info = "<html>
<p>v = 0; any current.</p>
</html>"));
end Ground;
