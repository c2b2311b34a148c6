// error: redeclare.incompatible line 5
model Test
  type Row = Real[3];
  type Table = Real[2, 3];
  replaceable Row x[2] = fill(1, 2, 3) constrainedby Table;
end Test;
