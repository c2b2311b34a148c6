// error: connect.quantity line 15 names a.p.v, b.p.v says `Pressure`
package T
  connector C
    Real v;
    flow Real f;
  end C;
  model Part
    parameter String what;
    C p;
  end Part;
  model Test
    Part a(what = "", p(v(quantity = "Pressure"))), b(what = "", p(v(quantity = "Temperature")));
    Part c(what = "");
  equation
    connect(a.p, c.p); connect(c.p, b.p);
    a.p.f = 1;
    b.p.f = 2;
    c.p.v = 3;
  end Test;
end T;
