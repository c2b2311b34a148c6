// error: type.not-boolean line 5
model Test
  Real y; Boolean b[1, 1];
equation
  when b then
    y = 1;
  end when;
  b = {{time > 1}};
end Test;
