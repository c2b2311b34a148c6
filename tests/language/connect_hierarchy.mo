// A connector in a connector, an array of connectors, and one part of a bundle.
connector Pin
  Real v;
  flow Real i;
end Pin;
connector Plug
  Pin pin[2];
  Pin shield;
end Plug;
model Load
  Plug plug;
equation
  for k in 1:2 loop
    plug.pin[k].v = plug.pin[k].i;
  end for;
  plug.shield.v = 0;
end Load;
model Single
  Pin p;
equation
  p.v = time;
end Single;
model Test
  Load a;
  Load b;
  Single s;
equation
  connect(a.plug, b.plug);
  connect(s.p, a.plug.pin[2]);
end Test;
