// error: statement.return line 6 names Test
model Test
  Real x;
algorithm
  x := 1;
  return;
end Test;
