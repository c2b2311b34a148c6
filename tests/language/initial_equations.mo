// Initial equations, fixed starts, and equations that come from declarations.
model Test
  parameter Real p(fixed = false);
  Real x(start = 1, fixed = true);
  Real v = der(x);
initial equation
  v = 0;
  if x > 0 then
    p = 1;
  else
    p = 2;
  end if;
equation
  der(v) = -p * x;
end Test;
