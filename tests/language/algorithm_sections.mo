// Algorithm sections: left limits and start values, loops, jumps, when, elements by a varying index, assert.
package Algorithms
  record Pair
    Real a;
    Integer n;
  end Pair;

  function limited
    input Real u;
    input Real limit;
    output Real y;
    output Real active;
  algorithm
    assert(limit > 0, "limit must be positive");
    active := 0;
    y := u;
    if u > limit then
      y := limit;
      return;
    end if;
    for i in 1:3 loop
      if y > -limit then
        active := i;
        break;
      end if;
      y := y + limit;
    end for;
  end limited;

  model Test
    Real x(start = 1, fixed = true), y, z[2](start = {3, 4}), peak(start = 0.1), limit;
    Integer n(start = 1, fixed = true), steps[3], k;
    Boolean up;
    Real active;
    Real table[3] = {x, 2 * x, time};
    Pair pair;
    parameter Real p(fixed = false, start = 2);
  initial algorithm
    p := p + x;
    p := 2 * p;
  equation
    der(x) = -y;
  algorithm
    y := 0;
    for i in 1:3, j in 1:2 loop
      y := y + i * j * x;
    end for;
    z[1] := y;
    pair.a := z[2];
    if time > 2 then
      z[2] := time;
    elseif time > 1 then
      assert(z[2] > 0, "z must be positive");
      z[1] := time;
    end if;
    pair.n := n;
  algorithm
    up := time > 0.5;
    when {up, sample(0, 0.1)} then
      n := n + 1;
      if n > 3 then
        n := 1;
      end if;
      steps[n] := steps[n] + 1;
      peak := max(peak, x);
    elsewhen x < 0.1 then
      n := 1;
      terminate("too small");
    end when;
  algorithm
    (limit, active) := limited(table[n], 0.5);
    k := 1;
    while k < 5 loop
      k := 2 * k;
    end while;
  end Test;
end Algorithms;
