within TenSpeed.Failures;
model TieUp "Clutch C3 fails on in second gear"
  extends FailingBench(line(t_fail = {1e6, 1e6, 9, 1e6, 1e6, 1e6}, each p_fail = p_on));
  annotation(
    experiment(StopTime = 11, Tolerance = 1e-6, Interval = 1e-2),
    Documentation(info = "<html>
<p>Second holds B1, B2 and C2. With C3 as well four elements act on four degrees of freedom: nothing can turn but what slips,
and the vehicle is slowed down by its clutches.</p>
</html>"));
end TieUp;
