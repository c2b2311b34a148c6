// A base class finds its names around itself, even when a derived class declares the same name.
package P
  package Lib
    constant Real g = 9.81;
    model Base
      Real x = g;
    end Base;
  end Lib;
  model Test
    extends Lib.Base;
    Real g = 1;
  end Test;
end P;
