// error: when.several line 8 names closed
model Test
  Boolean closed;
equation
  when time > 1 then
    closed = true;
  end when;
  when time > 2 then
    closed = false;
  end when;
end Test;
