within TenSpeed.Interfaces;
partial model PartialAccumulatorStage "Level of the line-pressure accumulator valve"
  extends PartialRegulatorStage;
  Hydraulics.Interfaces.Port port "Line";
  annotation(Documentation(info = "<html>
<p>Port of every level.</p>
</html>"));
end PartialAccumulatorStage;
