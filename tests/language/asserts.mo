// assert with levels, also by name; a message computed at run time is kept as it is written.
model Test
  Real x = time;
equation
  assert(x < 10, "too large");
  assert(condition = x > -1, message = "small", level = AssertionLevel.warning);
  assert(x < 3, "x is " + String(x));
end Test;
