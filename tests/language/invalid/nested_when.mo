// error: equation.nested-when line 7 names Test
model Test
  discrete Real x;
  Real t = time;
equation
  when t > 1 then
    when t > 2 then
      x = 1;
    end when;
  end when;
end Test;
