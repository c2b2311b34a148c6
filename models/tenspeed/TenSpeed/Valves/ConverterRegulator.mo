within TenSpeed.Valves;
model ConverterRegulator "Converter regulator valve with the volume of its line"
  extends Interfaces.PartialReliefRegulator(redeclare replaceable model Stage = ConverterStage);
  annotation(Documentation(info = "<html>
<p>Holds the converter line 5 bar above the atmosphere by passing on to lubrication what the converter does not take.</p>
</html>"));
end ConverterRegulator;
