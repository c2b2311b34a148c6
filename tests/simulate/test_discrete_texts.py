"""Messages of assertions and of terminate hold the values that variables have when they are needed."""

from __future__ import annotations

import acausal

MODEL = """
model Test
  type Mode = enumeration(off, slow);
  parameter Mode mode = Mode.slow;
  parameter String name = "tank";
  Boolean above = x > 0.2;
  Integer n = if above then 3 else 2;
  Real x = time;
  Real same = x;
equation
  assert(x < 0.5, name + ": " + String(same, 3) + " " + String(above) + " " + String(n) + " " + String(mode),
    AssertionLevel.warning);
  when time > 0.75 then
    terminate("ended at " + String(time));
  end when;
end Test;
"""


def test_messages_hold_values() -> None:
    result = acausal.loads(MODEL, "Test").compile().simulate(stop_time=1.0)
    (warning,) = result.warnings
    assert warning.message.startswith("tank: 0.5 true 3 slow")
    assert result.ended is not None
    assert result.ended.message == "ended at 0.75"
