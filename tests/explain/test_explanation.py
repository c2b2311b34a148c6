"""What is explained: differentiated equations, dependencies, incidence, text, JSON."""

from __future__ import annotations

import json
from typing import cast

import pytest

import acausal
from acausal.errors import LookupProblem, UsageProblem
from acausal.explain.collect import block_equations
from acausal.explain.explanation import Explanation, explain
from acausal.explain.text import explanation_text
from acausal.symbolic.describe import equation_text
from acausal.symbolic.expressions.text import to_text
from tests.explain.models import PENDULUM, chain, explained

TWO_MASSES = """\
model TwoMasses "Rigidly joined"
  Real s1(start = 0), v1(start = 0), s2, v2, f;
equation
  v1 = der(s1);
  v2 = der(s2);
  s1 = s2;
  der(v1) = f;
  2*der(v2) = 1 - f;
end TwoMasses;
"""


@pytest.fixture(scope="module")
def pendulum() -> Explanation:
    return explained(PENDULUM)


def test_index_reduction_tells_equation_times_and_line(pendulum: Explanation) -> None:
    (entry,) = pendulum.differentiated
    assert (equation_text(entry.equation), entry.times, entry.alias) == ("x ^ 2 + y ^ 2 = 1", 2, "")
    assert entry.equation.span.line == 13


def test_alias_elimination_differentiates_too() -> None:
    explanation = explained(TWO_MASSES)
    assert explanation.system.index == 3
    (position, speed) = explanation.differentiated
    assert (equation_text(position.equation), position.times) == ("s1 = s2", 2)
    assert speed.times == 1
    assert speed.equation.span.line in (4, 5)
    assert f"`s1 = s2` (<string>:6) twice, while {position.alias} was eliminated" in explanation.text


def test_dependencies_are_those_of_the_equations(pendulum: Explanation) -> None:
    needs, needed_by = pendulum.dependencies.needs, pendulum.dependencies.needed_by
    position, speed, force = (pendulum.block_of(name) for name in ("y", "v", "F"))
    assert needs[position] == ()
    assert needs[speed] == (position,)
    assert needs[force] == (position, speed)
    assert force in needed_by[speed]
    assert all(other < number for number, others in needs.items() for other in others)


def test_incidence_is_a_permutation_to_block_lower_triangular_form() -> None:
    explanation = explained(chain(7))
    found = explanation.incidence
    size = len(found.equations)
    assert size == len(found.unknowns) == sum(found.sizes)
    assert sorted(found.row_to) == sorted(found.column_to) == list(range(size))
    assert max(found.sizes) > 1
    block_at = [number for number, n in enumerate(found.sizes) for _ in range(n)]
    for row, column in found.pairs:
        assert block_at[found.column_to[column]] <= block_at[found.row_to[row]]
        unknown = to_text(found.unknowns[column])
        assert unknown in equation_text(found.equations[row])
    before_sorting = sum(column > row for row, column in found.pairs)
    assert before_sorting, "the model's own order would not have shown anything"


def test_every_equation_is_in_the_incidence_once(pendulum: Explanation) -> None:
    shown = sorted(equation_text(equation) for equation in pendulum.incidence.equations)
    blocks = pendulum.system.blocks
    assert shown == sorted(equation_text(e) for block in blocks for e in block_equations(block))


@pytest.mark.parametrize("number", [0, -1, 99])
def test_a_block_that_is_not_there(pendulum: Explanation, number: int) -> None:
    with pytest.raises(UsageProblem) as raised:
        pendulum.block_text(number)
    assert "numbered from 1 to 5" in raised.value.diagnostics[0].hint


def test_a_state_is_in_no_block(pendulum: Explanation) -> None:
    with pytest.raises(LookupProblem):
        pendulum.block_of("x")


def test_text_has_every_stage(pendulum: Explanation) -> None:
    text = pendulum.text
    for part in (
        "Pendulum: A point mass on a rod",
        "6 equations in 6 unknowns",
        "height = -y  by `height = -y` (<string>:7, binding)",
        "index 3: 2 levels of differentiation",
        "kept over y",
        "follows from x through",
        "then x solved for instead of y",
        "3 explicit, 1 linear, 1 nonlinear",
        "block 3: linear, 3 unknowns, 1 after tearing: F\n    then der(u), der(v)",
        "x = 0.8  assumed",
        "u = 0.0  assumed: not fixed, but needed as an equation; nobody gave it",
        "y = -0.6  guess",
        "Zero crossings: 1 crossing\n  x > 0  (<string>:12)",
        "causalise 0.",
    ):
        assert part in text
    assert str(pendulum) == text


def test_long_lists_are_cut_unless_everything_is_wanted() -> None:
    explanation = explained(chain(30))
    assert "and 10 more; --all shows them" in explanation.text
    assert "block 30: " not in explanation.text
    whole = explanation_text(explanation, everything=True)
    assert "--all" not in whole
    assert all(f"v[{i}]" in whole for i in range(1, 31))


def test_a_model_of_nothing_can_be_explained() -> None:
    explanation = explained("model Nothing end Nothing;")
    assert "0 equations in 0 unknowns" in explanation.text
    assert "States" in explanation.text
    assert "<h3>Nothing</h3>" in explanation.html()
    with pytest.raises(UsageProblem):
        explanation.block_text(1)


def test_block_text(pendulum: Explanation) -> None:
    text = pendulum.block_text(3)
    assert text.startswith("block 3 of 5 of Pendulum: linear, 3 unknowns, 1 after tearing\n")
    for part in (
        "unknowns: F, der(u), der(v)",
        "tearing variables: F",
        "der(u) = -F * x  (<string>:11)",
        "(<string>:13, differentiated twice)",
        "from x ^ 2 + y ^ 2 = 1",
        "linear in F; given these",
        "given: x,",
        "block 1 (y)",
        "block 2 (v)",
    ):
        assert part in text
    assert "\\dot" not in text
    assert "\\dot{u} = - F \\cdot x" in pendulum.block_text(3, latex=True)
    assert "needed by\n    block 2 (v)" in pendulum.block_text(1)


def test_json_has_the_promised_keys(pendulum: Explanation) -> None:
    data = pendulum.to_json()
    assert json.loads(json.dumps(data)) == data
    promised = "model equations variables aliases differentiated states choices blocks initial zero_crossings"
    assert {*promised.split(), "warnings", "seconds"} <= set(data)
    assert data["aliases"] == [
        {"name": "height", "value": "-y", "equation": {"text": "height = -y", "file": "<string>", "line": 7}}
    ]
    blocks = cast("list[dict[str, object]]", data["blocks"])
    assert [block["number"] for block in blocks] == [1, 2, 3, 4, 5]
    assert [block["torn"] for block in blocks] == [1, 0, 1, 0, 0]
    assert data["zero_crossings"] == [{"relation": "x > 0", "file": "<string>", "line": 12}]


def test_from_python() -> None:
    explanation = acausal.loads(PENDULUM).compile().explain()
    assert repr(explanation) == "<Explanation of Pendulum: 5 blocks>"
    assert "codegen" in explanation.seconds


def test_what_was_not_causalised_cannot_be_explained() -> None:
    with pytest.raises(UsageProblem):
        explain(acausal.loads(PENDULUM).run({}, "flat"))
