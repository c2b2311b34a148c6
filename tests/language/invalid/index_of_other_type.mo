// error: type.index line 5 names x
model Test
  type Gear = enumeration(low, high);
  Real x[Gear] = {1, 2};
  Real y = x[1];
end Test;
