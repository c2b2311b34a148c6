// error: type.discrete line 11
function whole
  input Real u;
  output Integer n;
algorithm
  n := integer(u);
end whole;
model Test
  Integer n;
equation
  n = whole(time);
end Test;
