// error: lookup.unknown-class line 7 names P.B
package P
  model A
  end A;
end P;
model Test
  import P.B;
  B b;
end Test;
