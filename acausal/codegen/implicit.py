"""The model left implicit: the tearing variables are unknowns of the integrator."""

from __future__ import annotations

import casadi as ca
from casadi import Function

from acausal.codegen.casadi_expressions import jacobian
from acausal.codegen.functions import Code, state_leaves
from acausal.codegen.scope import Scope
from acausal.symbolic.expressions.expr import der


def implicit_form(code: Code) -> Function:
    """`(t, x, p, m, u, d, z) -> (f, J)`: `f = (xdot, residuals)` and `J = d f / d (x, z)`, sparse and exact.

    At a solution the residuals are zero; there are as many as tearing variables.
    """
    program = code.dynamic
    scope = Scope([*program.groups, ("z", program.guesses)])
    scope.run(program.blocks)
    implicit = [segment.block for segment in program.segments if segment.implicit]
    rates = [der(state) for state in state_leaves(code.system)]
    residuals = [residual.value for block in implicit for residual in block.residuals]
    both = scope.column([*rates, *residuals])
    x, z = scope.inputs[scope.names.index("x")], scope.inputs[scope.names.index("z")]
    return scope.function("implicit", [("f", both), ("J", jacobian(both, ca.vertcat(x, z)))])
