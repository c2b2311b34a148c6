// error: lookup.duplicate-element line 4 names A
model Test
  Real A = 1;
  model A
  end A;
end Test;
