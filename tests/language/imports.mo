// Qualified, renaming, wildcard and group imports (13.2.1).
package Source
  constant Real a = 1;
  constant Real b = 2;
  constant Real c = 3;
  package Deep
    constant Real d = 4;
    function twice
      input Real u;
      output Real y = 2 * u;
    algorithm
    end twice;
  end Deep;
end Source;
model Test
  import Source.a;
  import second = Source.b;
  import Source.{c, Deep};
  import Source.Deep.*;
  Real u = a;
  Real v = second;
  Real w = c + Deep.d;
  Real x = twice(d);
end Test;
