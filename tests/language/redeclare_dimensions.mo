// The same type again may fix sizes, also of what is not replaceable; an open enumeration takes any other.
model Table
  Real x[:, :] = fill(1, size(x, 1), size(x, 2));
  replaceable type Mode = enumeration(:);
  parameter Mode mode;
end Table;

model Test
  type Gear = enumeration(low, high);
  Table table(redeclare Real x[2, 1], redeclare type Mode = Gear, mode = Gear.high);
end Test;
