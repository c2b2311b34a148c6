within Signals.Sources;
block Constant "Constant signal"
  parameter Real k "Value";
  Interfaces.RealOutput y "Signal";
equation
  y = k;
  annotation(Documentation(info = "<html>
<p>y = k.</p>
</html>"));
end Constant;
