// error: lookup.not-a-class line 11 names a
model A
  function f
    input Real u;
    output Real y = 2*u;
  algorithm
  end f;
end A;
model Test
  A a;
  function g = a.f;
  Real x = g(1);
end Test;
