// error: lookup.unknown-function line 3 names fooo
model Test
  Real x = fooo(time);
end Test;
