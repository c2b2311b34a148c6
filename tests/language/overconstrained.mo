package Overconstrained "Connections.* and equalityConstraint: a loop is broken at one connection (9.4)"
  record Angle "An angle that all connected connectors share"
    Real phi;
    function equalityConstraint
      input Angle a;
      input Angle b;
      output Real residue[1];
    algorithm
      residue := {sin(a.phi - b.phi)};
    end equalityConstraint;
  end Angle;

  connector Plug
    Angle angle;
    flow Real tau;
    Real v;
    flow Real i;
  end Plug;

  model Source
    Plug p;
  equation
    Connections.root(p.angle);
    p.angle.phi = time;
    p.v = 1;
  end Source;

  partial model Line
    Plug p;
    Plug n;
    Boolean forwards = Connections.rooted(p.angle);
  equation
    Connections.branch(p.angle, n.angle);
    p.i + n.i = 0;
    p.v - n.v = p.i;
  end Line;

  model Rigid
    extends Line;
    Boolean isRoot = Connections.isRoot(n.angle);
  equation
    Connections.potentialRoot(n.angle, priority = 2);
    if Connections.rooted(p.angle) then
      n.angle.phi = p.angle.phi;
    else
      p.angle.phi = n.angle.phi;
    end if;
    if Connections.isRoot(n.angle) then
      n.angle.phi = 0;
    else
      p.tau + n.tau = 0;
    end if;
  end Rigid;

  model Joint
    extends Line;
    Real q "Found from the loop that is closed";
  equation
    n.angle.phi = p.angle.phi + q;
    p.tau = 0;
    n.tau = 0;
  end Joint;

  model Test
    Source source;
    Joint a;
    Rigid b;
    Rigid alone "A part of its own, with a potential root";
  equation
    connect(source.p, a.p);
    connect(a.n, b.n);
    connect(b.p, source.p);
  end Test;
end Overconstrained;
