package Hydraulics "Zero-dimensional hydraulics of oil with entrained air"
  annotation(
    version = "0.1.0",
    uses(Mechanics(version = "0.1.0"), Signals(version = "0.1.0")),
    Documentation(info = "<html>
<p>Volumes, restrictions and spool valve parts. Port: absolute pressure <code>p</code> and volume flow <code>q</code>
at the port's density, positive into the component. Mass is conserved everywhere: in volumes through the density of
the oil, in restrictions by using the density of each side.</p>
<p>A volume stands between every two restrictions. No component fixes an initial pressure: a source may prescribe
it.</p>
</html>"));
end Hydraulics;
