// error: lookup.protected line 9 names P.Hidden
package P
protected
  model Hidden
    Real x = 1;
  end Hidden;
end P;
model Test
  P.Hidden h;
end Test;
