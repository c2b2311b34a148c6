// error: type.mismatch line 5 names b
type A = enumeration(x, y);
type B = enumeration(x, y);
model Test
  parameter Boolean b = A.x == B.x;
end Test;
