"""Too many, too few, structurally singular: the message names the equations and variables concerned."""

from __future__ import annotations

import pytest

from acausal.errors import BalanceProblem, Diagnostic
from acausal.lang.flat import FlatModel, Origin
from acausal.symbolic.balance import check_balance
from tests.growth import Work, growth
from tests.language.models import flat_model
from tests.symbolic.build import Attributes, chain, model


def problems(flat: FlatModel) -> tuple[Diagnostic, ...]:
    with pytest.raises(BalanceProblem) as caught:
        check_balance(flat)
    return caught.value.diagnostics


def lines(diagnostics: tuple[Diagnostic, ...]) -> list[int]:
    return [d.span.line for d in diagnostics if d.span is not None]


def test_balanced_models_pass() -> None:
    check_balance(model("der(x) = y", "y = x"))
    check_balance(model("x^2 + y^2 = 1", "der(x) = y"))
    check_balance(chain(20))


def test_one_too_many() -> None:
    first, *rest = problems(model("der(x) = y", "y = x", "z = time", "y = 2*x"))
    assert first.code == "balance.too-many-equations"
    assert "4 equations for 3 unknowns" in first.message
    assert set(first.names) == {"x", "y"}
    assert lines((first, *rest)) == [4, 2, 1]
    assert "remove one of these equations" in first.hint


def test_one_too_few() -> None:
    first, *rest = problems(model("der(x) = y", "y = z - u", "u = time"))
    assert first.code == "balance.too-few-equations"
    assert "3 equations for 4 unknowns" in first.message
    assert "u" not in first.names
    assert first.names[0] == "z"  # in one equation only: the likeliest to be forgotten
    assert len(rest) == 2


def test_singular_though_balanced_shows_both_parts() -> None:
    found = problems(model("a = 1", "a = 2", "b + c = a"))
    assert {d.code for d in found} == {"balance.structurally-singular"}
    text = " ".join(d.message for d in found)
    assert "`a = 1.0` (test.mo:1)" in text
    assert "2 unknowns (b, c) for only 1 equation" in text
    assert set(lines(found)) == {1, 2, 5, 6}


def test_a_variable_in_conditions_only_is_undetermined() -> None:
    found = problems(model("der(x) = if y > 0 then 1 else 2", "z = x", "z = 2*x"))
    assert any("y" in d.names for d in found)


def test_lists_stay_short() -> None:
    found = problems(model(*[f"x{i} = x{i + 1}" for i in range(40)], "x0 = 1", "x40 = 2"))
    assert len(found) == 5
    assert "and 37 more" in found[0].message


def test_an_unconnected_flow_is_the_hint() -> None:
    variables: dict[str, Attributes] = {"a.p.q": {"flow": True}, "a.p.v": {}}
    origins = {0: Origin.UNCONNECTED}
    found = problems(model("a.p.q = 0", "a.p.q = 3*time", variables=variables, origins=origins))
    assert "`a.p` is not connected" in found[0].message
    assert "connect `a.p`" in found[0].hint
    assert lines(found) == [1, 2]
    found = problems(model("a.x = a.p.q*a.p.v", "a.x = 1", variables=variables))
    assert "connect `a.p`" in found[0].hint


def test_two_sources_on_one_node() -> None:
    origins = {2: Origin.CONNECTION}
    found = problems(model("a.p = 1", "b.p = 2", "a.p = b.p", "a.q + b.q = 0", origins=origins))
    assert any("two sources" in d.hint for d in found)


def test_an_input_is_no_unknown() -> None:
    check_balance(model("der(x) = u", variables={"u": {"input": True}}))


def test_the_culprit_in_a_large_model() -> None:
    flat = chain(500)
    extra = model("cell[250].s = 1").equations
    merged = FlatModel(
        flat.name,
        "",
        flat.variables,
        (*flat.equations, *extra),
        (),
        (),
        flat.experiment,
        flat.span,
    )
    found = problems(merged)
    assert found[0].code == "balance.too-many-equations"
    assert any(d.span == extra[0].span for d in found)


def test_a_component_is_judged_by_what_may_be_connected_to_it() -> None:
    top: Attributes = {"top_level": True}
    variables: dict[str, Attributes] = {
        "p.v": top,
        "n.v": top,
        "p.i": top | {"flow": True},
        "n.i": top | {"flow": True},
    }
    origins = {2: Origin.UNCONNECTED, 3: Origin.UNCONNECTED}
    resistor = model(
        "p.v - n.v = 2*p.i", "p.i + n.i = 0", "p.i = 0", "n.i = 0", variables=variables, origins=origins
    )
    assert {d.code for d in problems(resistor)} == {"balance.structurally-singular"}
    check_balance(resistor, as_component=True)
    texts = ("p.v = 1", "p.v = 2", "p.i = 0", "n.i = 0")  # nothing connected to p could make up for that
    with pytest.raises(BalanceProblem):
        check_balance(model(*texts, variables=variables, origins=origins), as_component=True)


def test_a_large_gap_is_told_in_proportion_to_its_size() -> None:
    def prepare(size: int) -> Work:
        flat = flat_model(f"model Test Real x[{size}]; end Test;")
        return lambda: problems(flat)

    assert growth(prepare, 500, 8000) < 4
