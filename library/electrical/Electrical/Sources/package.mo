within Electrical;
package Sources "Voltages and currents given by a signal"
  annotation(Documentation(info = "<html>
<p>No source adds a state.</p>
</html>"));
end Sources;
