// error: inner.incompatible line 11 names part.system, system says it has no `h`
package Incompatible
  model Small
    parameter Real g = 9.81;
  end Small;
  model Large
    parameter Real g = 9.81;
    parameter Real h = 1;
  end Large;
  model Part
    outer Large system;
    Real x = system.h;
  end Part;
  model Test
    inner Small system;
    Part part;
  end Test;
end Incompatible;
