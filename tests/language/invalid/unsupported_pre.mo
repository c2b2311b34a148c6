// error: unsupported.pre line 3 names pre
model Test
  Boolean b = pre(b);
end Test;
