within Signals;
package Interfaces "Connectors"
  connector RealInput = input Real "Real value from elsewhere";
  connector RealOutput = output Real "Real value for others";
  connector BooleanInput = input Boolean "Boolean value from elsewhere";
  connector BooleanOutput = output Boolean "Boolean value for others";
  annotation(Documentation(info = "<html>
<p>An output may be connected to any number of inputs.</p>
</html>"));
end Interfaces;
