// Each of two parameters from the other one, by a choice: no circle.
package T
  function root
    input Real u;
    output Real y;
  algorithm
    if u > 1 then
      y := sqrt(u);
    else
      y := u;
    end if;
  end root;
model Test
  parameter Boolean warm = true annotation(Evaluate = true);
  parameter Boolean tunable = false;
  parameter Real T = if warm then 300 else h / 4200;
  parameter Real h = if warm then 4200 * T else 1e5;
  parameter Real a = if tunable then 1 else b;
  parameter Real b = if tunable then a else 3;
  parameter Real c = if warm then 2 else root(d);
  parameter Real d = if warm then root(c) else 3;
  Real x(start = h, fixed = true);
equation
  der(x) = T - x;
end Test;
end T;
