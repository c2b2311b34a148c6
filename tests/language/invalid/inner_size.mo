// error: inner.incompatible line 4 names a.x, x
package Sizes
  model A
    outer Real x[3];
    Real y = x[1];
  end A;
  model Test
    inner Real x[2] = {1, 2};
    A a;
  end Test;
end Sizes;
