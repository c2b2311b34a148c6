within TenSpeed.Benches;
model TorqueConverterDriveL3 "Drive of 60 s with the torque converter at level 3"
  extends Interfaces.ConverterDrive(redeclare model Torus = Converter.TorusL3);
  annotation(
    experiment(StopTime = 60, Tolerance = 1e-6, Interval = 0.02),
    Documentation(info = "<html>
<p>The circuit at level 3, the lock-up clutch with its cylinder, engine and vehicle.</p>
</html>"));
end TorqueConverterDriveL3;
