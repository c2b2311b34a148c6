// error: assignment.target line 8 names p says a parameter
model Test
  parameter Real p = 1;
  Real y = time;

equation
  when y > 1 then
    p = y;
  end when;
end Test;
