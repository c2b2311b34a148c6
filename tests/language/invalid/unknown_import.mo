// error: lookup.unknown-import line 3 names Nowhere.A
model Test
  import Nowhere.A;
  A a;
end Test;
