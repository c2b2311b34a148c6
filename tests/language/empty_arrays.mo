model Part
  parameter Real k = 1;
  Real x = k * time;
end Part;

model Test "Arrays without elements keep the type of their elements"
  parameter Integer n = 0;
  Part parts[n];
  Real none[n] = parts.x;
  Real total = sum(parts.x) + sum(none);
  Real more[:] = cat(1, {1, 2}, none);
end Test;
