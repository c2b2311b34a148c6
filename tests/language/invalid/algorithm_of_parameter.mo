// error: assignment.target line 5 names p says a parameter
model Test
  parameter Real p = 1;
algorithm
  p := 2;
end Test;
