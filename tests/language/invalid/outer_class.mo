// error: unsupported.outer-class line 10 names f
package OuterClass
  function f0
    input Real u;
    output Real y;
  algorithm
    y := u;
  end f0;
  model A
    outer function f = f0;
    Real y = f(time);
  end A;
  model Test
    inner function f = f0;
    A a;
  end Test;
end OuterClass;
