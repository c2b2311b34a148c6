// error: equation.connect-in-when line 11 names a, b
model Test
  connector Pin
    Real v;
    flow Real i;
  end Pin;
  Pin a;
  Pin b;
equation
  when time > 1 then
    connect(a, b);
  end when;
end Test;
