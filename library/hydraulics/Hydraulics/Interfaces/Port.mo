within Hydraulics.Interfaces;
connector Port "Hydraulic port"
  Units.AbsolutePressure p "Absolute pressure";
  flow Units.VolumeFlowRate q "Volume flow into the component at the density of the port's pressure";
  annotation(Documentation(info = "<html>
<p>Connected ports have the same pressure, hence the same density, so volume flows that sum to zero conserve
mass.</p>
</html>"));
end Port;
