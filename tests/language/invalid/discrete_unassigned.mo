// error: type.discrete-unassigned line 3 names d
model Test
  discrete Real d = 1;
end Test;
