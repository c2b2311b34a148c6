// Fields of arrays without elements: of connectors, records, and in algorithms.
package Empty
  connector Port
    input Boolean set;
  end Port;
  record Pair
    Real a;
    Real b[2];
  end Pair;
  block Any
    parameter Integer n = 0;
    Port ports[n];
    Pair pairs[n];
    output Boolean y;
    output Real total;
  equation
    y = max({false, max(ports.set)});
    total = sum(pairs.a) + size(pairs.a, 1);
  end Any;
  model Test
    Any any, one(n = 1, pairs(a = {3}, b = {{1, 2}}));
  equation
    one.ports[1].set = time > 1;
  end Test;
end Empty;
