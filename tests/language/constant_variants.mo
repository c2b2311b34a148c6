// Sizes that depend on constants of the component's own class and of packages.
package P
  constant Integer nX = 2;
  model A
    constant Integer m = nX + 1;
    Real x[m];
  equation
    for i in 1:m loop
      x[i] = i;
    end for;
  end A;
  model Test
    A a;
    Real y = a.m;
  end Test;
end P;
