// A class inside a model uses the constants of the component around it, with their modifications.
model A
  constant Real k = 1;
  model Inside
    Real x = k;
  end Inside;
  Inside i;
end A;
model Test
  A plain;
  A changed(k = 3);
end Test;
