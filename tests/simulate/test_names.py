"""Results by name: derivatives of aliases stand for those of what they are equal to."""

from __future__ import annotations

import pytest

from acausal.api import loads
from acausal.errors import LookupProblem

ALIASES = """
model Aliases
  Real x(start = 1, fixed = true, unit = "m");
  Real same(unit = "m") = x;
  Real minus(unit = "m") = -same;
  Real again(unit = "m") = minus;
  Real still = 3;
equation
  der(x) = -2*x;
end Aliases;
"""


@pytest.mark.parametrize(("name", "factor"), [("x", -2), ("same", -2), ("minus", 2), ("again", 2)])
def test_derivatives_of_aliases(name: str, factor: float) -> None:
    run = loads(ALIASES).compile().simulate(stop_time=1.0)
    assert run.values(f"der({name})") == pytest.approx(factor * run.values("x"))
    assert run.unit(f"der({name})") == "m/s"


@pytest.mark.parametrize("name", ["der(still)", "der(nothing)", "der(der(x))", "der(", "der()"])
def test_what_has_no_derivative_is_an_error(name: str) -> None:
    run = loads(ALIASES).compile().simulate(stop_time=0.1)
    with pytest.raises(LookupProblem) as raised:
        run.values(name)
    assert raised.value.codes == ("result.unknown-name",)
