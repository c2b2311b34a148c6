// error: function.too-long line 7 names f
function f
  input Real u;
  output Real y = u;
algorithm
  while true loop
    y := y + 1;
  end while;
end f;
model Test
  Real x = f(time);
end Test;
