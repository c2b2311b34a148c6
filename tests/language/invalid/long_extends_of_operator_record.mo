// error: extends.kind line 6 names Special, Number
operator record Number
  Real x;
end Number;
operator record Special
  extends Number;
end Special;
model Test
  Special s(x = 1);
end Test;
