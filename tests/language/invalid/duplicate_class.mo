// error: lookup.duplicate-element line 3 names A
model Test
  model A
  end A;
  model A
  end A;
end Test;
