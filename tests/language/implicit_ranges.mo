// Ranges that follow from what the iterator subscripts: in equations, algorithms, functions and comprehensions.
package ImplicitRanges
  type Level = enumeration(low, high);
  record Pair
    Real a[2];
  end Pair;

  function halves
    input Real u[:];
    output Real y[size(u, 1)];
  algorithm
    for k loop
      y[k] := u[k] / 2;
    end for;
  end halves;

  model Test
    Real x[3], m[2, 3], e[Level, Boolean], s[3] = halves(x), total;
    Pair pairs[2](a = {{1, 2}, {3, time}}), copies[2];
    Real squares[2] = {pairs[i].a[1]^2 for i};
  equation
    for i loop
      x[i] = i * time;
    end for;
    for i, j loop
      m[i, j] = i + j * time;
    end for;
    for k, b loop
      e[k, b] = if b then Integer(k) * time else 0;
    end for;
    for i, j loop
      copies[i].a[j] = 2 * pairs[i].a[j];
    end for;
  algorithm
    total := 0;
    for i loop
      total := total + x[i];
    end for;
  end Test;
end ImplicitRanges;
