// error: type.mismatch line 7 names n
model Test
  Integer n;

equation
  when time > 1 then
    n = 2 * time;
  end when;
end Test;
