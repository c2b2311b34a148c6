package TenSpeed "Ten-speed automatic transmission"
  annotation(
    version = "0.1.0",
    uses(
      Mechanics(version = "0.1.0"),
      Hydraulics(version = "0.1.0"),
      Electrical(version = "0.1.0"),
      Signals(version = "0.1.0")),
    Documentation(info = "<html>
<p>A front-wheel-drive automatic with four planetary gearsets, three clutches, three brakes and one two-way clutch.
So far: the kinematics in every gear, and the main-regulator circuit of the hydraulics.</p>
</html>"));
end TenSpeed;
