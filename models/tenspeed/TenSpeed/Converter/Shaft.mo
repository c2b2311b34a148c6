within TenSpeed.Converter;
connector Shaft "End of a shaft of which only the speed matters"
  Mechanics.Units.AngularVelocity w "Speed of the shaft";
  flow Mechanics.Units.Torque tau "Torque into the component";
  annotation(Documentation(info = "<html>
<p>Connected shafts turn at the same speed and their torques sum to zero. It has no angle, so that a converter has no
states but those of its laws; <code>FlangeAdapter</code> joins it to flanges with angles.</p>
</html>"));
end Shaft;
