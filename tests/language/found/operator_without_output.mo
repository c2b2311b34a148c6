package P
  operator record Pair
    Real a;
    encapsulated operator '-'
      function subtract
        import P.Pair;
        input Pair x;
        input Pair y;
        parameter Pair result = Pair(x.a - y.a);
      algorithm
      end subtract;
    end '-';
  end Pair;
  model Test
    Pair p(a = time);
    Pair q = p - p;
  end Test;
end P;
