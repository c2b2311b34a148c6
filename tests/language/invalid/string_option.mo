// error: call.arguments line 3 names significantDigits
model Test
  constant String s = String(2, significantDigits = 3);
end Test;
