"""Invariance: how a model is written changes nothing about what it says.

Equations and declarations are shuffled, variables renamed, equations negated or their sides exchanged. Then
the number of states and the index stay, derivatives at random consistent points agree to 1e-9, and
trajectories agree within ten times the tolerance.
"""

from __future__ import annotations

import random
import re

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import acausal
from acausal.api import CompiledModel
from tests.symbolic.numeric import run as evaluate

Equations = list[str]
RTOL = 1e-6
_NAME = re.compile(r"\b(?!der\b|sin\b|time\b)[a-z]\w*")


@st.composite
def rigid_masses(draw: st.DrawFn) -> Equations:
    """Masses in a row, neighbours joined rigidly, by a lever or by a spring; the last one may be held."""
    count = draw(st.integers(2, 5))
    joints = draw(
        st.lists(st.sampled_from(["rigid", "gear", "spring"]), min_size=count - 1, max_size=count - 1)
    )
    held = draw(st.booleans())
    result: Equations = [f"v{k} = der(s{k})" for k in range(count)]
    left = ["sin(3*time)", *(f"r{k}" for k in range(count - 1))]
    right = [*(f"f{k}" for k in range(count - 1)), "0"]
    for k in range(count):
        push = "g" if held and k == count - 1 else "0"
        result.append(f"{0.5 + 0.25 * k}*der(v{k}) = {left[k]} - {right[k]} + {push}")
    for k, joint in enumerate(joints):
        ratio = 1.5 if joint == "gear" else 1.0
        result.append(f"r{k} = {ratio}*f{k}")
        if joint == "spring":
            result.append(f"f{k} = 40*(s{k} - s{k + 1}) + 0.5*(v{k} - v{k + 1})")
        else:
            result.append(f"s{k} - {ratio}*s{k + 1} = 0.1")
    if held:
        result.append(f"s{count - 1} = 0.2*sin(2*time)")
    return result


PENDULUM = [
    "der(x) = vx",
    "der(y) = vy",
    "2*der(vx) = -p*x + 0.3*sin(time)",
    "2*der(vy) = -p*y - 2*9.81",
    "x^2 + y^2 = 2.25",
]
CIRCUIT = [
    "1*der(u1) = i1",
    "2*der(u2) = i2",
    "2*der(u3) = i2 - 0.1*u3",
    "u1 = u2 + u3",
    "i1 + i2 = (sin(time) - u1)/5 + j",
    "0.3*der(j) = -u1 - w",
    "w + 0.1*w^3 = 2*j",
]
systems = st.one_of(rigid_masses(), st.just(PENDULUM), st.just(CIRCUIT))


def names_of(equations: Equations) -> list[str]:
    return sorted({name for equation in equations for name in _NAME.findall(equation)})


def rewritten(equations: Equations, rng: random.Random) -> tuple[Equations, dict[str, str]]:
    """The same system written differently, and the new names."""
    names = names_of(equations)
    fresh = [f"{letter}{i}" for i, letter in enumerate(rng.choices("bchklmnqz", k=len(names)))]
    renamed = dict(zip(names, fresh, strict=True))
    result: Equations = []
    for equation in equations:
        left, right = _NAME.sub(lambda match: renamed[match[0]], equation).split(" = ")
        forms = [
            f"{left} = {right}",
            f"-({left}) = -({right})",
            f"{right} = {left}",
            f"({left}) - ({right}) = 0",
        ]
        result.append(rng.choice(forms))
    rng.shuffle(result)
    return result, renamed


def compiled(equations: Equations, names: list[str], starts: dict[str, float] | None = None) -> CompiledModel:
    given = starts or {}
    declared = "".join(
        f"  Real {name}{f'(start = {given[name]!r})' if name in given else ''};\n" for name in names
    )
    text = f"model Law\n{declared}equation\n" + "".join(f"  {e};\n" for e in equations) + "end Law;"
    return acausal.loads(text).compile()


@settings(max_examples=25)
@given(systems, st.randoms(use_true_random=False))
def test_writing_changes_neither_states_nor_derivatives(equations: Equations, rng: random.Random) -> None:
    first = compiled(equations, names_of(equations), {"x": 0.9, "y": -1.2} if equations is PENDULUM else None)
    other, renamed = rewritten(equations, rng)
    shuffled = list(renamed.values())
    rng.shuffle(shuffled)
    starts = {renamed["x"]: 0.9, renamed["y"]: -1.2} if equations is PENDULUM else None
    second = compiled(other, shuffled, starts)
    assert len(first.states) == len(second.states)
    assert first.index == second.index
    old = {new: name for name, new in renamed.items()}
    point = {name: rng.uniform(0.4, 0.9) for name in first.states}
    known = evaluate(first.causal, point, time=0.7, guesses={"x": 0.9, "y": -1.2})
    values = {renamed[name]: value for name, value in known.items() if name in renamed}
    found = evaluate(second.causal, {s: values[s] for s in second.states}, time=0.7, guesses=values)
    compared = 0
    for name, value in found.items():
        inner = name.removeprefix("der(").removesuffix(")")
        plain = name.replace(inner, old[inner]) if inner in old else ""
        if plain in known:
            compared += 1
            assert value == pytest.approx(known[plain], rel=1e-9, abs=1e-9), plain
    assert compared >= len(names_of(equations))


@settings(max_examples=15)
@given(systems, st.randoms(use_true_random=False))
def test_writing_changes_no_trajectory(equations: Equations, rng: random.Random) -> None:
    """From the same point; which variables are states may differ, so all are given as start values."""
    first = compiled(equations, names_of(equations), {"x": 0.9, "y": -1.2} if equations is PENDULUM else None)
    run = first.simulate(stop_time=2.0, rtol=RTOL, interval=0.05)
    starts = {name: float(run.values(name)[0]) for name in names_of(equations)}
    other, renamed = rewritten(equations, rng)
    shuffled = list(renamed.values())
    rng.shuffle(shuffled)
    second = compiled(other, shuffled, {renamed[name]: value for name, value in starts.items()})
    again = second.simulate(stop_time=2.0, rtol=RTOL, interval=0.05)
    for name in first.states:
        expected = run.values(name)
        scale = 1.0 + float(np.max(np.abs(expected)))
        assert np.max(np.abs(again.values(renamed[name]) - expected)) < 10 * RTOL * scale, name
