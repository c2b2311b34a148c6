within TenSpeed.Converter;
model FlangeAdapter "Joins a shaft without angle to a flange with angle"
  Shaft shaft "Side of the converter";
  Mechanics.Rotational.Interfaces.Flange flange "Side of a gearbox or engine";
equation
  // One speed, no torque lost
  shaft.w = der(flange.phi);
  shaft.tau + flange.tau = 0;
  annotation(Documentation(info = "<html>
<p>w = d phi / dt; the torques sum to zero. An angle that the other side does not have becomes a state.</p>
</html>"));
end FlangeAdapter;
