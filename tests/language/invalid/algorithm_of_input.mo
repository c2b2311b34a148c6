// error: assignment.target line 5 names u says an input
model Test
  input Real u;
algorithm
  u := time;
end Test;
