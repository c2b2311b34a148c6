// error: unsupported.when line 5
model Test
  discrete Real x;
equation
  when time > 1 then
    x = 1;
  end when;
end Test;
