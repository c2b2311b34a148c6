// Conditional components take their connections along when they are not there (4.4.5).
connector Pin
  Real v;
  flow Real i;
end Pin;
model Source
  Pin p;
equation
  p.v = 1;
end Source;
model Load
  parameter Boolean with_ground = true;
  Pin p;
  Pin g if with_ground;
  Source inner_source if not with_ground;
protected
  Pin internal;
equation
  connect(g, internal);
  connect(inner_source.p, internal);
  p.i = p.v - internal.v;
end Load;
model Test
  Source s;
  Load a;
  Load b(with_ground = false);
equation
  connect(s.p, a.p);
  connect(s.p, b.p);
  connect(a.g, s.p);
  connect(b.g, s.p);
end Test;
