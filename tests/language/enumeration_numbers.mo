// Integer(e) and E(i) of literals, variables and arrays; a varying subscript of an array without elements.
model EnumerationNumbers
  type Level = enumeration(low, middle, high);
  function next
    input Level level;
    output Level result;
  algorithm
    result := if level == Level.high then Level.high else Level(Integer(level) + 1);
  end next;
  parameter Integer n = 0;
  Level level = if time > 1 then Level.high elseif time > 0.5 then Level(2) else Level.low;
  Level above = next(level), levels[2] = Level({1, Integer(level)});
  Integer i = Integer(level) + Integer(Level.middle), k[2] = Integer(levels);
  Real x = time + Integer(level), nothing[n];
  Real y = if i < 9 then x else nothing[i];
end EnumerationNumbers;
