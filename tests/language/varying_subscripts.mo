// Subscripts that vary at run time choose among the elements; asserted to be within the size.
package Varying
  type Level = enumeration(low, high);
  record Pair
    Real a;
    Real b[2];
  end Pair;
  constant Real gain[Level, 2] = {{1, 2}, {3, 4}};

  function pick
    input Real u[:];
    input Integer i;
    output Real y;
  protected
    Real w[size(u, 1)] = 2 * u;
  algorithm
    w[i] := 0;
    y := w[i] + sum(w);
  end pick;

  model Test
    Integer n = 1 + integer(2 * time);
    Boolean b = time > 0.5;
    Level level = if b then Level.high else Level.low;
    Real x[3] = {1, 2, 3} * time, m[2, 2] = [1, 2; 3, 4] * time, y, rows[2], amount, flags[Boolean] = {time, 2 * time};
    Pair pairs[2](a = {1, 2}, b = {{time, 1}, {2, time}});
    Pair chosen = pairs[n];
  equation
    y = x[n] + flags[b];
    rows = m[n, :];
    amount = gain[level, n] + pick(x, n) + (if n <= 2 and x[n] > 0 then x[n + 1] else 0);
  end Test;
end Varying;
