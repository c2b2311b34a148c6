// error: expandable.not-fed line 4 names part.bus.u
package Feeding
  connector RealInput = input Real;
  block User RealInput u; Real x = u; end User;
  expandable connector Bus
  end Bus;
  model Part
    Bus bus;
    User user;
  equation
    connect(user.u, bus.u);
  end Part;
  model Test
    Part part;
  end Test;
end Feeding;
