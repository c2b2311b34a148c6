// Defaults, named arguments, several results, protected variables, loops, early return, arrays.
package P
  function polynomial
    input Real x;
    input Real c[:];
    output Real y;
  algorithm
    y := 0;
    for i in size(c, 1):-1:1 loop
      y := y * x + c[i];
    end for;
  end polynomial;
  function two
    input Real a;
    input Real b = 2 * a;
    output Real s = a + b;
    output Real d;
  protected
    Real half = b / 2;
  algorithm
    d := a - half;
  end two;
  function clip
    input Real u;
    input Real limit = 1;
    output Real y;
  algorithm
    if u > limit then
      y := limit;
    elseif u < -limit then
      y := -limit;
    else
      y := u;
    end if;
  end clip;
  function first_above
    input Real v[:];
    input Real limit;
    output Integer index = 0;
  algorithm
    for i in 1:size(v, 1) loop
      if v[i] > limit then
        index := i;
        break;
      end if;
    end for;
  end first_above;
  function power_of_two
    input Integer n;
    output Integer y;
  algorithm
    if n <= 0 then
      y := 1;
      return;
    end if;
    y := 2 * power_of_two(n - 1);
  end power_of_two;
  function halvings
    input Integer n;
    output Integer count = 0;
  protected
    Integer rest = n;
  algorithm
    while rest > 1 loop
      rest := div(rest, 2);
      count := count + 1;
    end while;
  end halvings;
  model Test
    Real p = polynomial(time, {1, 2, 3});
    Real s;
    Real d;
    Real only_d;
    Real c = clip(limit = 2, u = p);
    parameter Integer index = first_above({1, 5, 9}, 4);
    parameter Integer big = power_of_two(10);
    parameter Integer count = halvings(20);
    Real many[3] = clip({time, 2, -5});
  equation
    (s, d) = two(p);
    (, only_d) = two(1, b = time);
  end Test;
end P;
