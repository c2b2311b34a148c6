// error: type.pre line 5 names x
model Test
  Real x = time, y;
equation
  y = pre(x);
end Test;
