// error: inner.ambiguous line 10 names a.system
package Ambiguous
  model First
    parameter Real g = 1;
  end First;
  model Second
    parameter Real g = 2;
  end Second;
  model A
    outer First system;
  end A;
  model B
    outer Second system;
  end B;
  model Test
    A a;
    B b;
  end Test;
end Ambiguous;
