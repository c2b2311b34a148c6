// Quoted identifiers keep their quotes and never mean the plain name.
model Test
  Real 'a.b' = 1;
  Real a = 'a.b' + 'x y'.z;
  model M
    Real z = 2;
  end M;
  M 'x y';
end Test;
