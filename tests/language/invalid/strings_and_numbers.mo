// error: type.not-numeric line 3 names s
model Test
  parameter String s = "a" + 1;
end Test;
