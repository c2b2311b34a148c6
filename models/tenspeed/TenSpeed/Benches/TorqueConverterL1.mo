within TenSpeed.Benches;
model TorqueConverterL1 "Sweep of the speed ratio of the converter at level 1"
  extends Interfaces.ConverterBench(redeclare model Torus = Converter.TorusL1);
  annotation(
    experiment(StopTime = 4020, Tolerance = 1e-6, Interval = 2),
    Documentation(info = "<html>
<p>Four states: w_p, w_t, w_s, Q.</p>
</html>"));
end TorqueConverterL1;
