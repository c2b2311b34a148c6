// Functions as arguments of functions: by name, with bound arguments, handed on, called element by element.
package P
  partial function Scalar
    input Real u;
    output Real y;
  end Scalar;
  function line
    extends Scalar;
    input Real a = 2;
    input Real b = 0;
  algorithm
    y := a * u + b;
  end line;
  function quadratic
    input Real u;
    output Real y = u * u;
  end quadratic;
  function mean
    input Scalar f;
    input Real low;
    input Real high;
    output Real y;
  algorithm
    y := (f(low) + f(u = high)) / 2;
  end mean;
  function twice
    input Scalar f;
    input Real u;
    output Real y;
  protected
    Real first;
  algorithm
    first := f(u);
    y := f(first) + mean(f, u, 2 * u);
  end twice;
  function shifted
    input Scalar f;
    input Real by;
    input Real u;
    output Real y = mean(function line(a = f(by), b = by), u, u);
  end shifted;
  model Test
    Real x = time;
    Real a = mean(quadratic, 0, x);
    Real b = mean(function line(b = 1), 0, x);
    Real c = mean(line, 0, x);
    Real d = twice(function line(a = x), 3);
    Real e = shifted(quadratic, 2, x);
    Real f = mean(f = function quadratic(), high = x, low = 1);
  end Test;
end P;
