// error: string.too-long line 8 says more than 1000000
package T
  function f
    input Integer n;
    output String s = "doubled";
  algorithm
    for i in 1:n loop
      s := s + s;
    end for;
  end f;
  model Test
    parameter Integer size = if f(60) == "" then 1 else 2;
    Real x[size] = fill(1.0, size);
  end Test;
end T;
