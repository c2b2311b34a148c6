// What an algorithm names is looked up where it is written, also where a function inherits it (5.3.1).
package T
  package Basics
    constant Real offset = 2;
    function twice
      input Real u;
      output Real y = 2 * u;
    algorithm
    end twice;
    function shifted
      input Real u;
      input Real by = offset;
      output Real y;
    algorithm
      y := twice(u) + by + offset;
    end shifted;
  end Basics;
  function renamed = Basics.shifted;
  function longer
    extends Basics.shifted(by = 7);
  end longer;
  model Test
    Real a = renamed(time);
    Real b = longer(time);
  end Test;
end T;
