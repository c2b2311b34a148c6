// der of expressions, noEvent, smooth, abs, sign, min, max, rounding, homotopy.
model Test
  Real x(start = 1);
  Real a = noEvent(if x > 0 then x else -x);
  Real b = smooth(1, if x < 0 then 0 else x ^ 2);
  Real c = der(2 * x + time);
  Real d = abs(x) + sign(x) + sqrt(x) + atan2(x, 1) + exp(-x);
  Real e = max(x, 0) + min(x, 1) + mod(7, 4) + div(7, 2) + rem(-7, 4) + floor(2.5) + ceil(2.5);
  Integer n = integer(2.9);
  Real f = homotopy(x ^ 2, simplified = x);
  Boolean g = x > 1 and not (x < 0 or time >= 2);
  Real h = if g then 1 elseif n == 1 then 2 else 3;
equation
  der(x) = -x;
end Test;
