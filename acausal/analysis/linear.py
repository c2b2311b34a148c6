"""The matrices of a compiled model at one point: dx'/dt = A x' + B u', y' = C x' + D u'.

They are exact: differentiated by CasADi through the solved implicit blocks, with the discrete values and
modes as they are.
"""

from __future__ import annotations

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


def matrices_at(evaluator: Evaluator, function: Function | None = None) -> Matrices:
    """The matrices at the evaluator's present point, whose blocks must be solved there."""
    code = evaluator.code
    chosen = function if function is not None else linear_function(code)
    e = evaluator
    values = chosen.call([e.t, e.x, e.p, e.m, e.u, e.d, e.guess])
    a, b, c, d = (np.asarray(value.full(), dtype=np.float64) for value in values)
    inputs = len(code.system.flat.inputs)  # what follows them are delayed values, which do not react at once
    return Matrices(a, b[:, :inputs], c, d[:, :inputs])
