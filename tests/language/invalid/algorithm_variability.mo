// error: type.discrete line 5 names n
model Test
  Integer n;
algorithm
  n := if noEvent(time > 1) then 1 else 2;
end Test;
