within TenSpeed.Converter;
package Functions "Laws of the circuit in steady flow"
  annotation(Documentation(info = "<html>
<p>All take the flow Q, positive from impeller to turbine to stator, and the speeds of impeller, turbine and stator.
Within |Q| &lt; Q_0 the laws of both directions are blended; outside they are exact.</p>
</html>"));
end Functions;
