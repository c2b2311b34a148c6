// error: connector.unbalanced line 18 names p says 1 flow variable and 2 potential
record Angle
  Real phi;
  function equalityConstraint
    input Angle a;
    input Angle b;
    output Real residue[1];
  algorithm
    residue := {a.phi - b.phi};
  end equalityConstraint;
end Angle;
connector Plug
  Angle angle;
  Real v;
  flow Real i;
end Plug;
model Test
  Plug p;
equation
  Connections.root(p.angle);
  p.angle.phi = 0;
  p.v = 1;
end Test;
