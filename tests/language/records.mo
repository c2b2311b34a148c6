// Records as parameter sets, constructed, nested, in arrays, passed to functions.
package P
  record Point
    Real x;
    Real y = 0;
  end Point;
  record Pair
    Real x;
    Real y;
  end Pair;
  record Line
    Point from;
    Point to;
    constant Integer dimension = 2;
  end Line;
  function moved
    input Point p;
    input Real by;
    output Point q;
  algorithm
    q := p;
    q.x := p.x + by;
  end moved;
  model Test
    parameter Point a = Point(1, 2);
    parameter Point b(x = 3);
    parameter Line line(from = a, to = Point(y = 5, x = 4));
    parameter Point list[2] = {a, Point(6)};
    Point p = moved(a, time);
    Pair q;
    Real sum_x = sum(list.x) + line.to.y;
  equation
    q = Pair(p.y, p.x);
  end Test;
end P;
