// A value for a whole record replaces the values given further in, not those beside it.
record R
  Real a = 1;
  Real b = 2;
end R;
model A
  parameter R r(a = 5);
end A;
model Test
  parameter R other(a = 10, b = 20);
  A plain;
  A whole(r = other);
  A part(r(b = 7));
end Test;
