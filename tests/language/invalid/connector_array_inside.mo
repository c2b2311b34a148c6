// error: connect.mismatch line 12 names a.v, b.v
connector Many
  Real v[2];
end Many;
connector More
  Real v[3];
end More;
model Test
  Many a;
  More b;
equation
  connect(a, b);
end Test;
