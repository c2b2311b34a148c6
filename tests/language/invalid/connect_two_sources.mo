// error: connect.two-sources line 16 names a.y, b.y
connector RealInput = input Real;
connector RealOutput = output Real;
block Source
  RealOutput y = 1;
end Source;
block Sink
  RealInput u;
end Sink;
model Test
  Source a;
  Source b;
  Sink s;
equation
  connect(a.y, s.u);
  connect(b.y, s.u);
end Test;
