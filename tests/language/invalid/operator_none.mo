// error: operator.none line 14 names Overloading.Pair says `/` is defined for record Overloading.Pair and Real
package Overloading
  operator record Pair
    Real a;
    encapsulated operator function '+'
      import Overloading.Pair;
      input Pair x;
      input Pair y;
      output Pair result = Pair(x.a + y.a);
    end '+';
  end Pair;
  model Test
    Pair x = Pair(time);
    Pair y = x / 2.0;
  end Test;
end Overloading;
