// error: extends.kind line 10 names Test.Q, Test.P
model Test
  package P
    operator record Number
      Real x;
    end Number;
    constant Real c = 1;
  end P;
  package Q
    extends P;
  end Q;
  Real x = Q.c;
end Test;
