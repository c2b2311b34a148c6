// model, block, connector, record, type, function, package, class and short classes of them.
package P
  type Length = Real(unit = "m", min = 0);
  type Height = Length(max = 10);
  connector Pin
    Real v;
    flow Real i;
  end Pin;
  connector Port = Pin;
  record R
    Real a;
    Real b = 2;
  end R;
  block Gain
    input Real u;
    output Real y;
    parameter Real k = 1;
  equation
    y = k * u;
  end Gain;
  block Triple = Gain(k = 3);
  class C
    Height h = 1;
  end C;
  function f
    input Real u;
    output Real y;
  algorithm
    y := u + 1;
  end f;
  function g = f;
  model Test
    Port p;
    R r(a = 1);
    Triple triple(u = time);
    C c;
    Real x = g(time);
  equation
    p.v = 5;
  end Test;
end P;
