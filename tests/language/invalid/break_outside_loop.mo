// error: function.break line 6 names Test
model Test
  Real x;
algorithm
  x := 1;
  break;
end Test;
