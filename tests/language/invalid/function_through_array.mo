// error: lookup.not-a-function line 11 names a.f
model A
  function f
    input Real u;
    output Real y = 2*u;
  algorithm
  end f;
end A;
model Test
  A a[2];
  Real x = a.f(1);
end Test;
