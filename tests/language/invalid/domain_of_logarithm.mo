// error: call.domain line 3 names log10
model Test
  Real x = log10(0);
end Test;
