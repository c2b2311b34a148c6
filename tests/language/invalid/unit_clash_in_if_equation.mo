// error: unit.clash line 8
model Test
  parameter Real w(unit = "rad/s") = 1;
  parameter Real P(unit = "W") = 2;
  Real tau(unit = "N.m");
  Real x(unit = "s") = time;
equation
  if x > 1 then
    tau = 0;
  else
    tau = P;
  end if;
end Test;
