// error: assertion.failed line 7 says this cannot be
package P
  function f
    input Real u;
    output Real y = u;
  algorithm
    assert(u > 0, "this cannot be");
  end f;
  model Test
    Real x = time * f(-1);
  end Test;
end P;
