"""What a snapshot says about itself: growth that a frozen relation explains, events that are near."""

from __future__ import annotations

import pytest

import acausal

SHUT = """model Shut "Pressure feeds itself until the valve opens"
  parameter Real crack = 2;
  Real p(start = 1, fixed = true), s(start = 0, fixed = true), v(start = 0, fixed = true);
  Boolean open = p > crack;
equation
  der(p) = 0.1*p - (if open then 5*(p - crack) else 0);
  der(s) = v; der(v) = 3*p - 900*s - 4*v;
end Shut;"""


def test_growth_is_explained_by_the_valve_that_is_shut() -> None:
    snapshot = acausal.loads(SHUT).compile().linearize()
    (growth,) = snapshot.growing
    assert growth.states == ("p",)
    assert [relation.text for relation in growth.calmed_by] == ["p > crack"]
    assert any("frozen with `p > crack`" in text and "as false" in text for text in snapshot.warnings)


def test_growth_without_a_reason() -> None:
    text = "model Grows Real x(start = 0); equation der(x) = 2*x; end Grows;"
    snapshot = acausal.loads(text).compile().linearize()
    assert [growth.calmed_by for growth in snapshot.growing] == [()]
    assert any("unstable here" in text for text in snapshot.warnings)


def test_seconds_to_a_crossing() -> None:
    text = """model Falls Real x(start = 3, fixed = true); Boolean low = x < 1, late = time > 0.5;
      Real y(start = 0, fixed = true);
      equation der(x) = -4; der(y) = if low or late then -1 else -2*y; end Falls;"""
    snapshot = acausal.loads(text).compile().linearize()
    seconds = {relation.text: relation.seconds for relation in snapshot.relations}
    assert seconds == {"x < 1": pytest.approx(0.5), "time > 0.5": pytest.approx(0.5)}
    assert len(snapshot.near_events) == 2  # Euler may step 1 s
    later = acausal.loads(text).compile().linearize(0.7)
    assert all(relation.seconds == float("inf") for relation in later.relations)


def test_looking_leaves_the_point_as_it_is() -> None:
    compiled = acausal.loads(SHUT).compile()
    one, other = compiled.linearize(0.4), compiled.linearize(0.4)
    assert one.values.tolist() == other.values.tolist() == one.point.x.tolist()
    assert one.point.m.tolist() == [0.0]
