// Sums, products, matrix operations and element-wise operators.
model Test
  Real u[2] = {time, 1};
  Real v[2] = {3, 4};
  constant Real A[2, 2] = [1, 2; 3, 4];
  Real sums[2] = u + v - 2 * u;
  Real scalar_product = u * v;
  Real product[2] = A * u;
  Real square[2, 2] = A ^ 2;
  Real each_one[2] = u .* v ./ {2, 2};
  Real shifted[2] = u .+ 1;
  Real total = sum(v) + max(v) + min({5, 6}) + product2;
  Real product2 = product({2, 3, 4});
  Real t[2, 2] = transpose(A) + identity(2) + diagonal({5, 6});
  Real joined[4] = cat(1, u, zeros(2));
  Real ones23[2, 3] = fill(7, 2, 3);
  Real c[3] = cross({1, 0, 0}, {0, 1, time});
  Real line[3] = linspace(0, 1, 3);
end Test;
