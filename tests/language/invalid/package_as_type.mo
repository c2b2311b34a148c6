// error: type.not-a-component-type line 5 names p
package P
end P;
model Test
  P p;
end Test;
