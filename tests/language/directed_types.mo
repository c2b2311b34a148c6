// A type may carry the direction of what is declared with it, also in functions.
model Test
  type In = input Real;
  type Out = output Real[2];

  function f
    In u;
    Out y;
  algorithm
    y := {u, 2*u};
  end f;

  Real x[2] = f(time);
end Test;
