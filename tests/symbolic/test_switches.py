"""What of equations and conditions makes events."""

from __future__ import annotations

import pytest

from acausal.errors import Source, Span, TypeProblem
from acausal.symbolic.events import switches
from acausal.symbolic.expressions.expr import TIME, call, const, relation
from acausal.symbolic.expressions.kernel import Named
from acausal.symbolic.leaves import Chains

SPAN = Span(Source("here", "x"), 0, 1)
CHAINS = Chains({}, {})


def test_the_integer_result_of_a_function_may_be_compared() -> None:
    status = call(Named("status", 1, "Integer"), TIME)
    assert switches([], [(relation("eq", status, const(0)), SPAN)], CHAINS).crossings == ()


def test_a_real_result_may_not() -> None:
    with pytest.raises(TypeProblem, match="compares Real values"):
        switches([], [(relation("eq", call(Named("value", 1), TIME), const(0)), SPAN)], CHAINS)
