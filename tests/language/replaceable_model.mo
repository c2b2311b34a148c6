// A class redeclared in a modification; modifications of the original short class are kept (7.3.2).
model Resistor
  parameter Real R = 1;
  parameter Real T = 20;
  Real v = R * T;
end Resistor;
model Thermo
  extends Resistor;
  parameter Real alpha = 0;
end Thermo;
model Circuit
  replaceable model Element = Resistor(R = 100);
  Element e[2];
end Circuit;
model Test
  parameter Real a = 0.5;
  Circuit plain;
  Circuit hot(redeclare model Element = Thermo(alpha = a), e(each T = 30));
end Test;
