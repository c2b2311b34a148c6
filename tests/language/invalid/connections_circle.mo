// error: connections.circle line 23 names a.r, b.r
package Circle
  record Angle
    Real phi;
    function equalityConstraint
      input Angle a;
      input Angle b;
      output Real residue[0];
    algorithm
    end equalityConstraint;
  end Angle;
  connector Plug
    Angle r;
    Real v;
    flow Real i;
  end Plug;
  model Test
    Plug a;
    Plug b;
  equation
    Connections.root(a.r);
    Connections.root(b.r);
    Connections.branch(a.r, b.r);
    a.v = 1;
    b.v = 1;
    a.r.phi = 1;
    b.r.phi = 1;
  end Test;
end Circle;
