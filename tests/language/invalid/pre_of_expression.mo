// error: type.pre line 5 says needs a variable
model Test
  Integer n;
equation
  n = pre(n + 1);
end Test;
