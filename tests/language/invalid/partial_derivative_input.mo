// error: function.partial-derivative line 8 says `z` is no input
package T
  function f
    input Real x;
    output Real y = x ^ 2;
  algorithm
  end f;
  function f_z = der(f, z);
  model Test
    Real a = f_z(time);
  end Test;
end T;
