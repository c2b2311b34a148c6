within TenSpeed.Benches;
model TorqueConverterL2 "Sweep of the speed ratio of the converter at level 2"
  extends Interfaces.ConverterBench(redeclare model Torus = Converter.TorusL2);
  annotation(
    experiment(StopTime = 4020, Tolerance = 1e-6, Interval = 2),
    Documentation(info = "<html>
<p>Three states: w_p, w_t, w_s.</p>
</html>"));
end TorqueConverterL2;
