// error: inner.missing line 9 names part.system says no component around it declares an `inner` `system`
package Missing
  partial model System "None can be added of a partial class"
    parameter Real g = 9.81;
  end System;

  model Part
    Real x = system.g;
    outer System system;
  end Part;

  model Test
    Part part;
  end Test;
end Missing;
