// error: call.arguments line 3 names format
model Test
  constant String s = String(1.5, format = "s");
end Test;
