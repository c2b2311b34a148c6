// Loops that run as long as a condition on variables holds, ended at the latest by one known at compile time.
package Loops
  function find "The interval of u in x, searched from where it was last"
    input Real x[:];
    input Real u;
    input Integer last = 1;
    output Integer i = last;
  algorithm
    if u >= x[i] then
      while i < size(x, 1) - 1 and u > x[i + 1] loop
        i := i + 1;
      end while;
    else
      while i > 1 and u < x[i] loop
        i := i - 1;
      end while;
    end if;
  end find;

  function leading "Number of positive elements at the beginning, and the first that is not"
    input Real x[:];
    output Real n = 0;
    output Real first = 0;
  algorithm
    for k in 1:size(x, 1) loop
      if x[k] <= 0 then
        first := x[k];
        return;
      end if;
      n := n + 1;
    end for;
  end leading;

  model Test
    parameter Real table[4] = {0, 1, 2, 4};
    Real x = find({0, 1, 3}, time), up = find(table, time, 3), n, first, y;
  equation
    (n, first) = leading({time, x, -up});
  algorithm
    y := 1;
    for i in 1:3 loop
      if y > time then
        break;
      end if;
      y := 2 * y;
    end for;
  end Test;
end Loops;
