// Literals, comparison, arrays and loops over an enumeration, Integer().
model Test
  type Mode = enumeration(off "rest", slip, stick);
  parameter Mode mode = Mode.slip;
  parameter Real gain[Mode] = {0, 1, 2};
  Real x[Mode];
  Real y = if mode == Mode.off then 0 else gain[Mode.stick];
  parameter Integer number = Integer(Mode.stick);
  parameter Boolean last = Mode.off < Mode.stick;
equation
  for m in Mode loop
    x[m] = gain[m] * time;
  end for;
end Test;
