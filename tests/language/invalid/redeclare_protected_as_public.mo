// error: redeclare.visibility line 8 names x
model A
protected
  replaceable Real x = 1;
end A;
model Test
  extends A;
  redeclare Real x = 2;
end Test;
