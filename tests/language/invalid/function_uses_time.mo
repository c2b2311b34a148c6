// error: function.time line 5 names f, time
function f
  output Real y;
algorithm
  y := 2*time;
end f;
model Test
  Real x = f();
end Test;
