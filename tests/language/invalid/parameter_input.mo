// error: class.component line 3 names u
model Test
  parameter input Real u = 1;
end Test;
