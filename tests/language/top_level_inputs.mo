// Inputs of the model itself are known from outside, unless they have a value.
connector RealInput = input Real;
connector Bus
  input Real command;
  output Real answer;
end Bus;
model Test
  RealInput u;
  input Real v = 3;
  output Real y;
  Bus bus;
equation
  y = u + v;
  bus.answer = 2 * bus.command;
end Test;
