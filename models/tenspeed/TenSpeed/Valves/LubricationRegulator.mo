within TenSpeed.Valves;
model LubricationRegulator "Lubrication regulator valve with the volume of its line"
  extends Interfaces.PartialReliefRegulator(redeclare replaceable model Stage = LubricationStage);
  annotation(Documentation(info = "<html>
<p>Holds the lubrication line 2 bar above the atmosphere by draining what the consumers do not take.</p>
</html>"));
end LubricationRegulator;
