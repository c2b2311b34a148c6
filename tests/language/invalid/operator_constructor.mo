// error: operator.none line 15 says `Overloading.Pair` is defined for Boolean
package Overloading
  operator record Pair
    Real a;
    encapsulated operator 'constructor'
      function fromReal
        import Overloading.Pair;
        input Real a;
        output Pair result(a = a);
      algorithm
      end fromReal;
    end 'constructor';
  end Pair;
  model Test
    Pair x = Pair(true);
  end Test;
end Overloading;
