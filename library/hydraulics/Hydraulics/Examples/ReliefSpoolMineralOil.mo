within Hydraulics.Examples;
model ReliefSpoolMineralOil "The same relief valve with another oil"
  extends ReliefSpool(
    valve(redeclare package Oil = Media.OilMineralVG32),
    feedback(redeclare package Oil = Media.OilMineralVG32));
  annotation(
    experiment(StopTime = 1, Tolerance = 1e-6),
    Documentation(info = "<html>
<p>A (p - p_0) = F_preload + c s + flow force at rest, whatever the oil. Every part of a valve takes the oil of the valve.</p>
</html>"));
end ReliefSpoolMineralOil;
