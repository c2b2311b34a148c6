// error: type.class-as-value line 5 names P
package P
end P;
model Test
  Real x = P;
end Test;
