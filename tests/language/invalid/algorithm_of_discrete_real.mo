// error: type.discrete line 6 names d says continuous
model Test
  Real d;
algorithm

  d := time;
  when time > 1 then d := 2; end when;
end Test;
