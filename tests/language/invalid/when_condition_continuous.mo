// error: when.condition line 5 says must be discrete
model Test
  Real x = time, y;
equation
  when noEvent(x > 1) then
    y = x;
  end when;
end Test;
