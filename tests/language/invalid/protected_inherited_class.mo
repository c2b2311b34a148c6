// error: lookup.protected line 12 names Q.M
package P
  model M
    Real x = 1;
  end M;
end P;
package Q
protected
  extends P;
end Q;
model Test
  Q.M m;
end Test;
