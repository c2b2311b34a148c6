// error: statement.when-in-clause line 6 names Test
model Test
  discrete Real x[2];
algorithm
  for i in 1:2 loop
    when time > i then
      x[i] := 1;
    end when;
  end for;
end Test;
