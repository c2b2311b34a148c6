// A modifier is looked up where it is written, not in the class it modifies.
package P
  constant Real k = 10;
  model A
    parameter Real k = 1;
    parameter Real p = k;
  end A;
  model Short = A(p = k);
  model Long
    extends A(p = 2 * k);
  end Long;
  model Test
    parameter Real k = 100;
    A a(p = k);
    Short s;
    Long l;
  end Test;
end P;
