// error: type.mismatch line 4 says takes an Integer
model Test
  type Level = enumeration(low, high);
  Level level = Level(1.0);
end Test;
