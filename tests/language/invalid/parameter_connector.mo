// error: component.prefix line 4 names u
model Test
  connector Signal = input Real;
  parameter Signal u = 1;
end Test;
