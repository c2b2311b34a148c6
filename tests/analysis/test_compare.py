"""Modes of two levels of fidelity find each other."""

from __future__ import annotations

from typing import cast

import acausal
from acausal.analysis.compare import comparison_json, pairs
from acausal.analysis.snapshot import Snapshot

COARSE = """model Shaft "Two inertias on a spring"
  parameter Real c = 1e4, J = 0.1, d = 0.3;
  Real a(start = 0), wa(start = 0), b(start = 0), wb(start = 0);
equation
  der(a) = wa; der(b) = wb; J*der(wa) = c*(b - a) - d*wa; J*der(wb) = c*(a - b);
end Shaft;"""

FINE = """model Fine "The same, with some mass in the middle of the spring"
  parameter Real c = 1e4, J = 0.1, d = 0.3, j = 1e-4;
  Real a(start = 0), wa(start = 0), b(start = 0), wb(start = 0), m(start = 0), wm(start = 0);
equation
  der(a) = wa; der(b) = wb; J*der(wa) = 2*c*(m - a) - d*wa; J*der(wb) = 2*c*(m - b);
  der(m) = wm; j*der(wm) = 2*c*(a - m) + 2*c*(b - m);
end Fine;"""


def snapshot(text: str) -> Snapshot:
    return acausal.loads(text).compile().linearize()


def test_what_only_one_has_stays_alone() -> None:
    coarse, fine = snapshot(COARSE), snapshot(FINE)
    found = [(pair.one, pair.other) for pair in pairs(coarse, fine)]
    assert found == [(1, 1), (2, 2), (3, 3), (None, 5)]
    modes = cast("list[dict[str, float]]", comparison_json(coarse, fine)["modes"])
    assert abs(modes[2]["frequency_change"]) < 1e-3
    assert modes[3]["mode"] is None
