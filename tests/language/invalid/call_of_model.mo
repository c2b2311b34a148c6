// error: call.not-a-function line 5 names A
model A
end A;
model Test
  Real x = A(1);
end Test;
