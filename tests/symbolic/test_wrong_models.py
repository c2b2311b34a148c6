"""Models that an engineer gets wrong: every message names equation, variable, line, system and a way out."""

from __future__ import annotations

from pathlib import Path

import pytest

import acausal
from acausal.errors import AcausalError

FILE = Path(__file__).with_name("WrongModels.mo")
LINES = FILE.read_text(encoding="utf-8").splitlines()

EXPECTED = {
    # model: code, what the line of the first diagnostic holds, what its message says, what its hint says
    "NoGround": (
        "alias.loop",
        "connect(s.n, r.n)",
        "determines nothing in the running system",
        "connect a reference",
    ),
    "TwoVoltages": (
        "balance.structurally-singular",
        "t(V = 2)",
        "`s` and `t` both prescribe the potential",
        "remove `s` or `t`",
    ),
    "TwoCurrents": (
        "balance.structurally-singular",
        "Current s(I = 1), t",
        "`s` and `t` both prescribe the current through the same place",
        "let a capacitor take up the difference",
    ),
    "FloatingIsland": (
        "balance.structurally-singular",
        "Current s; Capacitor c",
        "the current that `s` prescribes balances by itself by way of `c`",
        "connect a ground there",
    ),
    "TwoSpeeds": (
        "balance.structurally-singular",
        "ConstantSpeed s, t",
        "`s` and `t` both prescribe the angle or speed of what `j` couples",
        "put a spring, damper or clutch between them",
    ),
    "TwoPressures": (
        "balance.structurally-singular",
        "Pressure s, t",
        "in turn nothing determines s.a.q, t.a.q",
        "remove `s` or `t`, or one of the connections",
    ),
    "TwoFlows": (
        "balance.structurally-singular",
        "Flow s, t",
        "`s` and `t` both prescribe the flow through the same place",
        "remove `s` or `t`, or let a volume take up the difference",
    ),
    "OpenPipe": (
        "balance.structurally-singular",
        "Pipe pipe",
        "`pipe.b` is not connected",
        "connect `pipe.b`, or remove `s`",
    ),
    "OpenTorque": (
        "balance.structurally-singular",
        "Torque t;",
        "`t.f` is not connected, which makes its torque zero (`t.f.tau = 0.0`) while `t` prescribes it",
        "connect `t.f`",
    ),
    "ForgottenEquation": (
        "balance.too-few-equations",
        "eff;",
        "1 unknown (eff) for no equation",
        "add an equation",
    ),
    "ExtraEquation": ("balance.too-many-equations", "r.i = 3", "`r.i = 3`", "remove one of these equations"),
    "EquationWithoutUnknown": (
        "balance.too-many-equations",
        "p = 4",
        "determines no unknown at all",
        "remove",
    ),
    "SameTwice": (
        "simulate.singular-block",
        "a = 2 * b",
        "`a = 2 * b`, `2 * a - 4 * b = 1`",
        "depend on each other",
    ),
    "SingularByValue": ("simulate.singular-block", "x + a * y", "in the initial system", "with a = 2"),
    "NothingSaid": (
        "alias.loop",
        "x = x",
        "`x = x` determines nothing",
        "the equation that is missing elsewhere",
    ),
    "ZeroResistance": ("simulate.singular-block", "v = R * i", "`s.V = r.R * r.i`", "with r.R = 0"),
    "NoRoot": (
        "simulate.no-solution",
        "x^2 + 1",
        "found no solution of a nonlinear block",
        "the search began at x = 0",
    ),
    "DrivenByInput": ("reduction.not-differentiable", "s.w = u", "`s.w = u`", "an input has no derivative"),
    "DrivenByJump": (
        "reduction.not-differentiable",
        "s.w = if",
        "do not provably meet",
        "a ramp without jump",
    ),
    "DrivenBySign": ("reduction.not-differentiable", "sign(", "sign jumps", "a ramp without jump"),
    "DrivenByStairs": ("reduction.not-differentiable", "floor(", "jumps", "a ramp without jump"),
    "GearLoop": (
        "reduction.redundant-constraints",
        "a.phi = i",
        "of the running system",
        "make one connection elastic",
    ),
    "TwoStarts": (
        "start.conflict",
        "c(v(start = 1, fixed = true))",
        "`c.v` is fixed at 1",
        "remove `fixed = true` from one",
    ),
    "StartsThroughGear": (
        "initialize.inconsistent",
        "k(phi(start = 1, fixed = true))",
        "beside the start value `j.phi` = 1",
        "`k.phi`, `j.phi`",
    ),
    "StartOffTheCircle": (
        "simulate.no-solution",
        "x^2 + y^2 = 1",
        "in the initial system",
        "start values x = 2 (fixed)",
    ),
    "TwoInitialEquations": (
        "initialize.inconsistent",
        "x = 2",
        "the initial equation `x = 2`",
        "one of the initial equations",
    ),
    "StartOfAConstant": (
        "start.conflict",
        "fixed = true",
        "its value is 3 by `x = 3`",
        "remove `fixed = true` from `x`",
    ),
    "CyclicParameters": ("parameter.cyclic", "a = b + 1", "a -> b -> a", "does not use the others"),
    "ParameterWithoutValue": ("parameter.no-value", "parameter Real p", "`p` has no value", "p = ..."),
    "RootOfNegative": ("simulate.not-finite", "y = sqrt(x)", "y is not a number at time 0.5", "with x ="),
    "AlwaysAState": ("states.always-impossible", "Real x", "it is constrained by", "use StateSelect.prefer"),
    "NeverAState": (
        "states.never-impossible",
        "x(stateSelect",
        "`x` has stateSelect = StateSelect.never",
        "use StateSelect.avoid",
    ),
    "ForgottenInput": (
        "balance.too-few-equations",
        "DrivenSpeed s;",
        "the input `s.w` has no value, and nothing is connected to it",
        "connect `s.w`",
    ),
    "TwoValues": (
        "balance.too-many-equations",
        "b = 2",
        "4 equations determine 3 unknowns",
        "remove one of these",
    ),
}


@pytest.mark.parametrize("name", EXPECTED)
def test_the_culprit_is_named(name: str) -> None:
    code, line, says, hint = EXPECTED[name]
    with pytest.raises(AcausalError) as caught:
        acausal.load(FILE, name=f"WrongModels.{name}").compile().simulate()
    first = caught.value.diagnostics[0]
    assert first.code == code
    assert first.span is not None
    assert line in LINES[first.span.line - 1]
    assert says in first.message
    assert hint in first.hint
    assert first.names
