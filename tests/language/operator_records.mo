package Overloading "Operators of an operator record: all forms of calls (14)"
  operator record Pair "Numbers with two parts"
    replaceable Real a;
    replaceable Real b;
    encapsulated operator 'constructor'
      function fromNumbers
        import Overloading.Pair;
        input Real a;
        input Real b = 0;
        output Pair result(a = a, b = b);
      algorithm
      end fromNumbers;
    end 'constructor';
    encapsulated operator function '0'
      import Overloading.Pair;
      output Pair result;
    algorithm
      result := Pair(0);
    end '0';
    encapsulated operator function '+'
      import Overloading.Pair;
      input Pair x;
      input Pair y;
      output Pair result;
    algorithm
      result := Pair(x.a + y.a, x.b + y.b);
    end '+';
    encapsulated operator '-'
      function negate
        import Overloading.Pair;
        input Pair x;
        output Pair result = Pair(-x.a, -x.b);
      end negate;
      function subtract
        import Overloading.Pair;
        input Pair x;
        input Pair y;
        output Pair result = Pair(x.a - y.a, x.b - y.b);
      end subtract;
    end '-';
    encapsulated operator function '*'
      import Overloading.Pair;
      input Pair x;
      input Pair y;
      output Pair result = Pair(x.a * y.a, x.b * y.b);
    end '*';
    encapsulated operator function '=='
      import Overloading.Pair;
      input Pair x;
      input Pair y;
      output Boolean result = x.a == y.a and x.b == y.b;
    end '==';
  end Pair;

  operator record Length = Pair(redeclare Real a(unit = "m"), redeclare Real b(unit = "m"));

  function first
    input Pair p;
    output Real y = p.a;
  end first;

  connector Pin
    Pair v;
    flow Pair i;
  end Pin;

  model Part
    Pin p;
    Pin n;
  equation
    p.v - n.v = 2 * p.i;
    p.i + n.i = Pair(0);
  end Part;

  model Source
    Pin p;
  equation
    p.v = Pair(time, 1);
  end Source;

  model Ground
    Pin p;
  equation
    p.v = Pair(0);
  end Ground;

  model Test
    parameter Pair k = Pair(2, 3);
    constant Boolean same = Pair(1, 2) == Pair(1, 2);
    parameter Real l(unit = "m") = 1;
    Length x = Pair(l);
    Pair y = x + l;
    Pair z = -x * k;
    Pair v[2] = {x, y};
    Pair w[2] = v + fill(k, 2) .* v;
    Pair m[2] = [1, 2; 3, 4] * v;
    Pair s = sum(v) - sum(k for i in 1:3);
    Pair c = if time > 1 then x else y;
    Real parts[2] = first(v);
    Real q[2] = v.b;
    Source source;
    Part part;
    Ground ground;
  equation
    connect(source.p, part.p);
    connect(part.n, ground.p);
  end Test;
end Overloading;
