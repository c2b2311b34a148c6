within Hydraulics.Examples;
model PressureRampOnVolume "A prescribed pressure removes the state of a volume"
  Sources.PressureSource pump(p_start = 1e5, p_end = 1e6, startTime = 0.2, duration = 0.5) "Pump";
  Components.Volume volume(n = 1, V_0 = 1e-3) "Closed volume";
  output Units.VolumeFlowRate error "Difference to the closed form";
equation
  connect(pump.port, volume.port[1]);
  // Closed form: q = V / K dp/dt
  error = volume.port[1].q - volume.V_0/Media.bulkModulus(volume.p, volume.fluid)*der(volume.p);
  annotation(
    experiment(StopTime = 1, Tolerance = 1e-6),
    Documentation(info = "<html>
<p>No state remains; the flow into the volume is V / K dp/dt.</p>
</html>"));
end PressureRampOnVolume;
