// error: lookup.unknown-name line 5 names k
package P
  constant Real k = 1;
  encapsulated model Test
    Real x = k;
  end Test;
end P;
