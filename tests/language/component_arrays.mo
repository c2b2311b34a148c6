// Arrays of components, nested, with modifications split over the elements.
model Cell
  parameter Real r = 1;
  Real x[2];
equation
  x = {r, time};
end Cell;
model Row
  parameter Integer n = 2;
  Cell cell[n](r = {10 * i for i in 1:n});
end Row;
model Test
  Row row[2](n = {1, 2});
  Cell square[2, 2](r = [1, 2; 3, 4]);
  Real all[2] = square[1, :].r;
  Real some = row[2].cell[end].x[2];
end Test;
