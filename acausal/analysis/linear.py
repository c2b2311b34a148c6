"""The matrices of a compiled model at one point: dx'/dt = A x' + B u', y' = C x' + D u'.

They are exact: differentiated by CasADi through the solved implicit blocks, with the discrete values and
modes as they are.
"""

from __future__ import annotations

from collections import OrderedDict
from dataclasses import dataclass

import casadi as ca
import numpy as np
from casadi import Function
from numpy.typing import NDArray

from acausal.codegen.casadi_expressions import FORWARD
from acausal.codegen.functions import Code
from acausal.simulate.evaluator import Evaluator

Matrix = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Matrices:
    """A (n, n), B (n, m), C (k, n), D (k, m); y are `Code.output_leaves`, in order."""

    a: Matrix
    b: Matrix
    c: Matrix
    d: Matrix


def alias_of(code: Code, name: str) -> tuple[float, str] | None:
    """The sign and the output that a variable equals, if it is one that was eliminated."""
    sign, seen = 1.0, name
    for _ in range(len(code.system.aliases) + 1):
        value = code.system.alias_values.get(seen)
        if value is None:
            return (sign, seen) if seen != name else None
        if value.op == "neg":
            sign, value = -sign, value.args[0]
        if value.op != "sym":
            return None
        seen = value.name
    return None


def linear_function(code: Code) -> Function:
    """`(t, x, p, m, u, d, z) -> (A, B, C, D)` as one Function; `z` is a guess of the tearing variables."""
    names = code.ode.name_in()
    symbols = [ca.MX.sym(name, *code.ode.size_in(i)) for i, name in enumerate(names)]
    derivative, solved = code.ode.call(symbols)
    outputs = code.outputs.call([*symbols[:-1], solved])[0]
    states, inputs = symbols[names.index("x")], symbols[names.index("u")]
    options = {"helper_options": FORWARD}
    matrices = [ca.jacobian(of, wrt, options) for of in (derivative, outputs) for wrt in (states, inputs)]
    return Function("linear", symbols, matrices, names, ["A", "B", "C", "D"], FORWARD)


def state_matrix(evaluator: Evaluator) -> Matrix:
    """A alone, at the evaluator's present point, whose blocks must be solved there."""
    evaluator.jac()
    pattern = evaluator.code.pattern
    dense = np.zeros((len(evaluator.x), len(evaluator.x)))
    dense[pattern.row(), pattern.get_col()] = evaluator.jacobian
    return dense


_made: OrderedDict[int, tuple[Code, Function]] = OrderedDict()
"""Linearising again needs no new function."""
_KEPT = 16


def _known(code: Code) -> Function:
    if id(code) not in _made:
        _made[id(code)] = (code, linear_function(code))
        if len(_made) > _KEPT:
            _made.popitem(last=False)
    return _made[id(code)][1]


def matrices_at(evaluator: Evaluator) -> Matrices:
    """The matrices at the evaluator's present point, whose blocks must be solved there."""
    e, code = evaluator, evaluator.code
    values = _known(code).call([e.t, e.x, e.p, e.m, e.u, e.d, e.guess])
    a, b, c, d = (np.asarray(value.full(), dtype=np.float64) for value in values)
    inputs = len(code.system.flat.inputs)  # what follows them are delayed values, which do not react at once
    return Matrices(a, b[:, :inputs], c, d[:, :inputs])
