// Assertions in functions become the model's, under the conditions on which they are reached.
package FunctionAssertions
  function root
    input Real u;
    output Real y;
  algorithm
    assert(u >= 0, "negative");
    y := sqrt(u);
  end root;

  function safe
    input Real u;
    input Boolean strict = false;
    output Real y;
  algorithm
    if u > 1 then
      y := root(u - 1);
      assert(y < 10, "large", AssertionLevel.warning);
    elseif strict then
      assert(u > 0, "strict");
      y := 1;
    else
      y := 0;
    end if;
  end safe;

  function text "Of a message, which is evaluated when it is needed"
    output String y = "z is negative";
  algorithm
    assert(false, "never");
  end text;

  model Part
    Real u = time;
    Real y;
  equation
    if u > 3 then
      y = root(u);
    else
      y = safe(u, true);
    end if;
  end Part;

  model Test
    parameter Real p = root(4);
    Part part;
    Real x = if time > 2 then root(time - 2) else safe(time);
    Boolean b = time > 1 and root(time - 1) > 0.5;
    Real z;
  algorithm
    z := 1;
    assert(z > 0, text());
    assert(x > -1, text());
    if b then
      z := root(x);
    end if;
  end Test;
end FunctionAssertions;
