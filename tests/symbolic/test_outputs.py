"""Compiling for chosen outputs: what is left gives the same values, what is gone is not needed."""

from __future__ import annotations

from typing import cast

import numpy as np
import pytest

import acausal
from acausal.errors import LookupProblem, UsageProblem

MIXED = """model Mixed
  parameter Real q(fixed = false, start = 1);
  Real x(start = 1, fixed = true), y, z(start = 0, fixed = true), w;
  Real v(start = 3, fixed = true), s, u(start = 7, fixed = true), f, g;
initial equation
  der(f) = 0;
equation
  der(x) = -2 * x;
  y = 2 * x;
  der(z) = x - z;
  w = z * z + y;
  s = 3 * v;
  v = der(s);
  der(u) = if s > 1e9 then w else -u;
  der(f) = w - f;
  g = f * q;
  assert(w < 100, "w is large");
  assert(x < 100, "x is large");
end Mixed;"""


@pytest.mark.parametrize(
    ("outputs", "kept"),
    [
        (["y"], "x y"),
        (["w"], "x y z w"),
        (["der(z)"], "x z"),
        (["s"], "v s"),
        (["u"], "x y z w v s u"),
        (["g"], "x y z w f g"),
        (["y", "s"], "x y v s"),
    ],
)
def test_only_what_is_needed_is_left(outputs: list[str], kept: str) -> None:
    model = acausal.loads(MIXED)
    part = model.compile(only=outputs)
    assert [v.name for v in part.causal.flat.unknowns] == kept.split()
    whole, less = model.compile().simulate(), part.simulate()
    for name in kept.split():
        assert np.allclose(less.final([name])[name], whole.final([name])[name], rtol=1e-4, atol=1e-6)


def test_what_is_left_out_is_reported() -> None:
    compiled = acausal.loads(MIXED).compile(only=["y"])
    assert compiled.summary["removed"] == {"for": ["y"], "equations": 7, "variables": 7}
    assert (compiled.summary["equations"], compiled.states) == (9, ("x",))
    data = compiled.explain().to_json()
    assert (data["equations"], data["variables"]) == (9, 9)
    removed = cast("dict[str, list[object]]", data["removed"])
    assert removed["variables"] == ["z", "w", "v", "s", "u", "f", "g"]
    assert [len(removed[key]) for key in ("equations", "initial_equations", "assertions")] == [7, 1, 1]
    assert "because y needs nothing of them: z, w, v" in compiled.explain().text


def test_an_assertion_stays_with_what_it_watches() -> None:
    compiled = acausal.loads(MIXED).compile(only=["y"])
    assert [a.message.value for a in compiled.causal.assertions] == ["x is large"]


def test_asking_a_result_for_what_is_gone_says_why() -> None:
    result = acausal.loads(MIXED).compile(only=["y"]).simulate()
    with pytest.raises(LookupProblem, match="`w` was left out"):
        result.values("w")


START = """model Start
  Real x, y(start = 6, fixed = {fixed}), p, z(start = 1, fixed = true);
{initial}equation
  der(x) = -x;
  y = 2 * x;
  der(p) = x;
  der(z) = -z * x;
end Start;"""


def kept(text: str) -> list[str]:
    return [v.name for v in acausal.loads(text).compile(only=["x"]).causal.flat.unknowns]


def test_a_fixed_start_that_determines_the_output_is_needed() -> None:
    """`y` is no state of its own: y = 6 makes x = 3. `z` is one, and says nothing about x."""
    text = START.format(fixed="true", initial="")
    assert kept(text) == ["x", "y"]
    assert acausal.loads(text).compile(only=["x"]).simulate()["x"].values[0] == 3
    assert kept(START.format(fixed="false", initial="")) == ["x"]


def test_initial_equations_bring_what_they_hold() -> None:
    assert kept(START.format(fixed="false", initial="initial equation\n  x = p + 1;\n")) == ["x", "p"]
    assert kept(START.format(fixed="false", initial="initial equation\n  p = 1;\n")) == ["x"]


def test_a_parameter_that_the_start_determines_brings_its_equations() -> None:
    text = """model M
      parameter Real k(fixed = false, start = 1);
      parameter Real twice = 2 * k;
      Real x(start = 1, fixed = true), w(start = 2, fixed = true), other(start = 1);
    initial equation
      der(w) = 3;
    equation
      der(x) = -twice * x;
      der(w) = k;
      der(other) = -other;
    end M;"""
    compiled = acausal.loads(text).compile(only=["x"])
    assert [v.name for v in compiled.causal.flat.unknowns] == ["x", "w"]
    assert compiled.simulate().parameters["twice"] == 6


def test_connected_components_and_index_reduction() -> None:
    """A pendulum beside a follower: the constraint stays whole, the follower goes."""
    text = """model M
      Real x(start = 0.6, fixed = true), y(start = -0.8), vx(fixed = true), vy, f, follower(start = 0);
    equation
      der(x) = vx; der(y) = vy;
      der(vx) = -f * x; der(vy) = -f * y - 9.81;
      x^2 + y^2 = 1;
      der(follower) = x - follower;
    end M;"""
    compiled = acausal.loads(text).compile(only=["f"])
    assert (compiled.index, len(compiled.states)) == (3, 2)
    assert "follower" not in [v.name for v in compiled.causal.flat.variables]
    whole = acausal.loads(text).compile().simulate(stop_time=2)
    assert compiled.simulate(stop_time=2).final(["f"])["f"] == pytest.approx(
        whole.final(["f"])["f"], rel=1e-3
    )


def test_wrong_outputs_are_refused() -> None:
    model = acausal.loads(MIXED)
    with pytest.raises(UsageProblem, match="has no variable `ww`") as caught:
        model.compile(only=["y", "ww"])
    assert caught.value.diagnostics[0].hint == "did you mean w?"
    for wrong in ("y", [], 3, [3]):
        with pytest.raises(UsageProblem, match="list of the names"):
            model.compile(only=wrong)  # type: ignore[arg-type]  # what a caller without types may do


EVENTS = """model Events
  Real x(start = 1, fixed = true), h(start = 1, fixed = true), v(start = 0, fixed = true);
  discrete Real bounces(start = 0, fixed = true), held(start = 0, fixed = true);
  Real y(start = 0, fixed = true), z, late;
equation
  der(x) = -x;
  der(h) = v;
  der(v) = -9.81;
  when h < 0 then
    bounces = pre(bounces) + 1;
    reinit(v, -0.8 * pre(v));
  end when;
  when sample(0, 0.1) then
    held = x;
  end when;
  der(y) = bounces;
  z = held + 1;
  late = z + 1;
  {end}
end Events;"""


@pytest.mark.parametrize(
    ("output", "kept"),
    [
        ("x", "x"),
        ("z", "x held z"),
        ("h", "h v bounces"),
        ("y", "h v bounces y"),
        ("late", "x held z late"),
    ],
)
def test_clauses_stay_with_what_they_change(output: str, kept: str) -> None:
    model = acausal.loads(EVENTS.format(end=""))
    part = model.compile(only=[output])
    assert [v.name for v in part.causal.flat.unknowns] == kept.split()
    whole = model.compile().simulate()
    assert part.simulate().final([output])[output] == pytest.approx(whole.final([output])[output], rel=1e-4)


def test_what_ends_the_run_stays() -> None:
    text = EVENTS.format(end="""when late < 2.5 then terminate("late"); end when;""")
    compiled = acausal.loads(text).compile(only=["h"])
    assert [v.name for v in compiled.causal.flat.unknowns] == ["x", "h", "v", "bounces", "held", "z", "late"]
