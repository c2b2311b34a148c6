// Functions whose loops depend on run-time values are kept as a unit where they are called at events.
package P
  function steps
    input Real u;
    input Real table[:];
    input Integer last = 1;
    output Integer next;
    output Real below;
  algorithm
    next := last;
    while next < size(table, 1) and u >= table[next] loop
      next := next + 1;
    end while;
    below := table[max(next - 1, 1)];
  end steps;
  function digits
    input Integer n;
    output Integer count;
  protected
    Integer rest = n;
  algorithm
    count := 0;
    while rest > 0 loop
      rest := div(rest, 10);
      count := count + 1;
    end while;
  end digits;
  model Part
    parameter String name = getInstanceName();
    discrete Integer k(start = 1, fixed = true);
    discrete Real level(start = 0, fixed = true);
    Integer d = digits(k);
    parameter Integer known = digits(1234);
  equation
    when sample(0, 0.1) then
      (k, level) = steps(time, {0, 0.25, 0.5}, pre(k));
    end when;
  end Part;
  model Test
    Part part;
    parameter String name = getInstanceName();
  end Test;
end P;
