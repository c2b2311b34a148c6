// error: operator.ambiguous line 22 names Overloading.Pair.'+'.first, Overloading.Pair.'+'.second
package Overloading
  operator record Pair
    Real a;
    encapsulated operator '+'
      function first
        import Overloading.Pair;
        input Pair x;
        input Pair y;
        output Pair result = Pair(x.a + y.a);
      end first;
      function second
        import Overloading.Pair;
        input Pair x;
        input Pair y;
        output Pair result = Pair(y.a);
      end second;
    end '+';
  end Pair;
  model Test
    Pair x = Pair(time);
    Pair y = x + x;
  end Test;
end Overloading;
