// A function is found through components: of the model that the component really has.
model Gain
  replaceable function f = Lookup.once;
  parameter Real k = 1;
end Gain;

package Lookup
  function once
    input Real u;
    output Real y = u;
  algorithm
  end once;

  function twice
    input Real u;
    output Real y = 2*u;
  algorithm
  end twice;
end Lookup;

model Two
  Gain inner_gain;
  Gain other(redeclare function f = Lookup.twice);
end Two;

model Test
  Gain plain[2];
  Two two;
  Real a = plain[2].f(time);
  Real b = two.other.f(time);
end Test;
