// error: type.partial line 7 names b
model Test
  partial model A
    Real x = 1;
  end A;
  model B = A;
  B b;
end Test;
