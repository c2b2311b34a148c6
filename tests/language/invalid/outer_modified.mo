// error: inner.outer-modified line 6 names a.x
package Modified
  model A
    parameter Real k = 1;
    outer Real
      x(start = 2);
  end A;
  model Test
    inner Real x = time;
    A a;
  end Test;
end Modified;
