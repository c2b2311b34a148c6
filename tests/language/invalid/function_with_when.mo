// error: function.when line 7 names f
function f
  input Real u;
  output Real y;
algorithm
  y := 0;
  when u > 1 then
    y := u;
  end when;
end f;
model Test
  Real x = f(1);
end Test;
