// The branches of an if-equation are equations of their own, each with its own unit.
model Test
  parameter Real w(unit = "rad/s") = 1;
  parameter Real P(unit = "W") = 2;
  Real tau(unit = "N.m");
  Real x(unit = "s") = time;
equation
  if x > 1 then
    tau = 0;
  else
    tau*w = P;
  end if;
end Test;
