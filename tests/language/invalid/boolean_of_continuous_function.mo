// error: type.discrete line 10
function above
  input Real u;
  output Boolean b = u > 1;
algorithm
end above;
model Test
  Boolean b;
equation
  b = above(time);
end Test;
