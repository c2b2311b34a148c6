// error: statement.nested-when line 6 names Test
model Test
  discrete Real x;
algorithm
  when time > 1 then
    when time > 2 then
      x := 1;
    end when;
  end when;
end Test;
