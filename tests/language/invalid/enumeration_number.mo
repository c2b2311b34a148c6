// error: type.index-out-of-range line 4 names Test.Level
model Test
  type Level = enumeration(low, high);
  Level level = Level(3);
end Test;
