"""Invariance on examples of the libraries: another order of everything, sides negated or exchanged."""

from __future__ import annotations

import random
from dataclasses import replace

import numpy as np
import pytest

import acausal
from acausal.api import CompiledModel
from acausal.codegen.functions import generate
from acausal.lang.flat import Equation, FlatModel
from acausal.symbolic.causalise import causalise
from acausal.symbolic.expressions.expr import Expr, neg, postorder

EXAMPLES = {
    "Mechanics.Rotational.Examples.PlanetaryReduction": 0.5,
    "Mechanics.Rotational.Examples.GearedInertias": 0.5,
    "Hydraulics.Examples.PumpAgainstOrifice": 0.1,
    "Electrical.Examples.CoilDrivesMass": 0.05,
}


def is_real(flat: FlatModel, expr: Expr) -> bool:
    """Whether only Reals that vary, numbers and arithmetic of them are in it, so that it may be negated."""
    plain = {"sym", "const", "der", "add", "mul", "sub", "neg", "div"}
    nodes = list(postorder([expr]))
    names = [node.name for node in nodes if node.op == "sym"]
    reals = [flat.by_name[name].type.name == "Real" for name in names if name in flat.by_name]
    return all(node.op in plain for node in nodes) and len(reals) == len(names) > 0 and all(reals)


def rewritten(flat: FlatModel, rng: random.Random) -> FlatModel:
    def other(equation: Equation) -> Equation:
        left, right = equation.left, equation.right
        if not (is_real(flat, left) and is_real(flat, right)):
            return equation
        return replace(
            equation,
            **rng.choice(
                [
                    {"left": left, "right": right},
                    {"left": neg(left), "right": neg(right)},
                    {"left": right, "right": left},
                ]
            ),
        )

    equations = [other(equation) for equation in flat.equations]
    variables = list(flat.variables)
    rng.shuffle(equations)
    rng.shuffle(variables)
    return replace(flat, equations=tuple(equations), variables=tuple(variables))


@pytest.mark.parametrize("name", EXAMPLES)
def test_how_an_example_is_written_changes_nothing(name: str) -> None:
    first = acausal.load(name).compile()
    flat = rewritten(first.flat, random.Random(name))
    assert [e.left for e in flat.equations] != [e.left for e in first.flat.equations]
    causal = causalise(flat)
    parts = replace(first.compilation, flat=flat, causal=causal, code=generate(causal))
    second = CompiledModel(parts)
    assert (len(second.states), second.index) == (len(first.states), first.index)
    stop = EXAMPLES[name]
    one, two = (model.simulate(stop_time=stop, rtol=1e-6, interval=stop / 10) for model in (first, second))
    for state in first.states:
        expected = one.values(state)
        scale = float(np.max(np.abs(expected))) + 1e-9
        assert np.max(np.abs(two.values(state)[: len(expected)] - expected)) < 1e-5 * scale, state
