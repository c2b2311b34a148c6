// pre, edge, change, initial, terminal, sample, delay and semiLinear, also of arrays.
model EventOperators
  type Mode = enumeration(off, on);
  parameter Real T = 0.5;
  parameter Boolean flag = true;
  Real x = sin(time), slope = semiLinear(x, 2, 3), late = delay(x, T), later[2] = delay({x, slope}, 1 + abs(x), 2);
  Integer n(start = 0, fixed = true), counts[2](each start = 0);
  Boolean b = x > 0.5, tick = sample(0, T), first = initial(), last = terminal();
  Boolean rising = edge(b), moved = change(n), every[2] = change(counts), known = pre(flag);
  Mode mode(start = Mode.off);
  discrete Real d;
equation
  n = if pre(b) then pre(n) + 1 else pre(n);
  counts = pre(counts) + {1, n};
  mode = if change(mode) then pre(mode) else Mode.on;
  when {tick, change(mode)} then
    d = pre(d) + pre(x) + time - pre(time);
  end when;
end EventOperators;
