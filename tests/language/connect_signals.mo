// Connectors that are types: inputs and outputs, also as arrays.
connector RealInput = input Real;
connector RealOutput = output Real;
block Gain
  RealInput u;
  RealOutput y;
  parameter Real k = 2;
equation
  y = k * u;
end Gain;
block Test
  RealInput u[2];
  RealOutput y;
  Gain gain[2](k = {3, 4});
  Gain last;
equation
  connect(u, gain.u);
  connect(gain[1].y, last.u);
  connect(last.y, y);
end Test;
