// when/elsewhen with vector conditions, in loops and under parameters; reinit, assert and terminate.
package When
  record Pair
    Real a;
    Integer n;
  end Pair;

  function split
    input Real u;
    output Real half;
    output Real rest;
  algorithm
    assert(u < 100, "too large to split");
    half := u / 2;
    rest := u - half;
  end split;

  block Counter
    parameter Boolean counting = true;
    parameter Real period = 0.1;
    input Boolean reset;
    output Integer count(start = 0, fixed = true);
    Real last;
  equation
    if counting then
      when {sample(0, period), reset} then
        count = if reset then 0 else pre(count) + 1;
        last = time;
      end when;
    else
      count = 0;
      last = 0;
    end if;
  end Counter;

  model Test
    Real h(start = 1, fixed = true), v(start = 0);
    Boolean low = h < 0, high;
    Real peak[2], half, rest;
    discrete Real level(start = 0.5);
    Pair pair, seen;
    Counter counter(reset = low), still(counting = false, reset = low);
  equation
    der(h) = v;
    der(v) = -9.81;
    pair.a = h;
    pair.n = counter.count;
    when initial() then
      reinit(v, 0);
    elsewhen low then
      reinit(v, if initial() then 0 else -0.8 * pre(v));
      assert(v > -10, "too fast");
      if counter.count > 10 then
        terminate("enough");
      end if;
    end when;
    when h > 2 then
      high = true;
      level = 2;
    elsewhen h < 1 then
      high = edge(low);
      level = pre(level) + pre(h);
    elsewhen initial() then
      high = false;
      level = 0;
    end when;
    for i in 1:2 loop
      when h > i then
        if counter.count > 3 then
          peak[i] = pre(peak[i]);
        elseif change(counter.count) then
          peak[i] = h;
        else
          peak[i] = i;
        end if;
      end when;
    end for;
    when sample(1, 1) then
      (half, rest) = split(h);
      seen = pair;
    end when;
  end Test;
end When;
