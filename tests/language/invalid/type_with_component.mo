// error: class.component line 4 names part
type Odd
  extends Real;
  Real part;
end Odd;
model Test
  Odd x = 1;
end Test;
