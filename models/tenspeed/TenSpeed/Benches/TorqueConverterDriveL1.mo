within TenSpeed.Benches;
model TorqueConverterDriveL1 "Drive of 60 s with the torque converter at level 1"
  extends Interfaces.ConverterDrive(redeclare model Torus = Converter.TorusL1);
  annotation(
    experiment(StopTime = 60, Tolerance = 1e-6, Interval = 0.02),
    Documentation(info = "<html>
<p>The circuit at level 1, the lock-up clutch with its cylinder, engine and vehicle.</p>
</html>"));
end TorqueConverterDriveL1;
