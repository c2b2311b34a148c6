// error: equation.when-in-initial line 5 names Test
model Test
  Real x(start = 1);
initial equation
  when time > 1 then
    x = 1;
  end when;
equation
  der(x) = 1;
end Test;
