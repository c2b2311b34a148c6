within TenSpeed.Failures;
model SupplyLost "The supply pressure is lost in second gear"
  extends FailingBench(line(each t_fail = 9));
  annotation(
    experiment(StopTime = 11, Tolerance = 1e-6, Interval = 1e-2),
    Documentation(info = "<html>
<p>All pressures fall to that of the air within 20 ms; what held, slips and lets go. The input runs away.</p>
</html>"));
end SupplyLost;
