within Mechanics.Rotational.Interfaces;
connector Flange "End of a shaft"
  Units.Angle phi "Absolute angle of the shaft";
  flow Units.Torque tau "Torque into the component";
  annotation(Documentation(info = "<html>
<p>Connected flanges have the same angle and their torques sum to zero. Names as in the Modelica Standard
Library.</p>
</html>"));
end Flange;
