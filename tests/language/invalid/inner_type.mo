// error: inner.incompatible line 4 names a.x, x
package Types
  model A
    outer Integer x;
    Real y = x;
  end A;
  model Test
    inner Real x = 1;
    A a;
  end Test;
end Types;
