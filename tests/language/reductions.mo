// sum, product, min, max over iterators.
model Test
  parameter Integer n = 3;
  Real x[n] = {time * i for i in 1:n};
  Real s = sum(x[i] ^ 2 for i in 1:n);
  Real p = product(i for i in 1:n);
  Real m = max(x[i] - i for i in 1:2);
  Real nothing = sum(x[i] for i in 1:0);
  Real two = sum(i * j for i in 1:2, j in 1:i);
end Test;
