"""Exact Jacobians of everything with respect to everything: CasADi Functions, made when they are asked for.

`derivatives`, `events` and `outputs` are functions of states, inputs and parameters: what is solved on the
way (torn blocks) follows by the implicit function theorem. `residuals` are the equations of the running
system, left minus right side, as functions of all their variables, `unknowns` among them, as if these were
independent. Every matrix is sparse, differentiated forward with coloured columns.
"""

from __future__ import annotations

from typing import Literal, TypeAlias

import casadi as ca
from casadi import SX, Function

from acausal.codegen.casadi_expressions import FORWARD, jacobian
from acausal.codegen.constants import bindings, function_of_parameters
from acausal.codegen.functions import Code, state_leaves
from acausal.codegen.scope import Scope
from acausal.codegen.slopes import slopes
from acausal.symbolic.expressions.expr import Expr, der, sub, sym

Of: TypeAlias = Literal["derivatives", "events", "outputs", "residuals"]
By: TypeAlias = Literal["states", "inputs", "parameters", "unknowns"]
_POSITION = {"states": 1, "parameters": 2, "inputs": 4}
"""Of the vector among the inputs of `Code.ode`."""
_OPTIONS = {"helper_options": FORWARD}


def jacobian_function(code: Code, of: Of, by: By) -> Function:
    """`(t, x, p, m, u, d, z) -> J`, the inputs of `Code.ode`; for `residuals` also `y`, the unknowns."""
    if of == "residuals":
        return _residuals(code, by)
    position = _POSITION[by]
    if code.ode.is_a("SXFunction"):
        symbols = code.ode.sx_in()
        graph = ca.jacobian(_scalars(code, of, symbols), symbols[position], _OPTIONS)
        return Function(f"{of}_by_{by}", symbols, [graph], code.ode.name_in(), ["J"], FORWARD)
    inputs = code.ode.mx_in()
    matrix = ca.jacobian(_matrices(code, of, inputs), inputs[position], _OPTIONS)
    return Function(f"{of}_by_{by}", inputs, [matrix], code.ode.name_in(), ["J"], FORWARD)


def _scalars(code: Code, of: Of, inputs: list[SX]) -> SX:
    """What is differentiated, with the blocks solved."""
    xdot, z = code.ode.call(inputs, True, False)
    return xdot if of == "derivatives" else _given(code, of).call([*inputs[:-1], z], True, False)[0]


def _matrices(code: Code, of: Of, inputs: list[ca.MX]) -> ca.MX:
    """The same where the blocks are solved by a nested Function."""
    xdot, z = code.ode.call(inputs, True, False)
    return xdot if of == "derivatives" else _given(code, of).call([*inputs[:-1], z], True, False)[0]


def explicit_jacobian(code: Code, of: Of, by: By) -> Function | None:
    """`(t, x, p, m, u, d, z) -> (J, rate)` by the implicit function theorem, with `z` solved at the point.

    For where `jacobian_function` gives no numbers: it multiplies slopes that are infinite behind a condition
    with directions that are zero. None for residuals, and as `slopes`.
    """
    if of == "residuals":
        return None
    blocks = [segment.block for segment in code.dynamic.segments if segment.implicit]
    roots = {
        "derivatives": tuple(der(leaf) for leaf in state_leaves(code.system)),
        "outputs": code.output_leaves,
        "events": tuple(sub(*relation.args) for relation in code.relations),
    }[of]
    return slopes(code.dynamic, roots, blocks, None, code.ode.name_in()[_POSITION[by]])


def _given(code: Code, of: Of) -> Function:
    return code.events if of == "events" else code.outputs


def residual_unknowns(code: Code) -> tuple[Expr, ...]:
    """The leaves that the running system determines, in slot order."""
    return code.dynamic.unknowns


def _residuals(code: Code, by: By) -> Function:
    groups = [*code.dynamic.groups, ("z", ()), ("y", residual_unknowns(code))]
    scope = Scope(groups)
    column = scope.column([sub(e.left, e.right) for e in code.system.equations])
    position = len(groups) - 1 if by == "unknowns" else _POSITION[by]
    matrix = jacobian(column, scope.inputs[position])
    return scope.function(f"residuals_by_{by}", [("J", matrix)])


def binding_slopes(code: Code) -> Function:
    """`p -> B`: how the bindings of parameters depend on parameters, one row and column each."""
    parameters = tuple(sym(name) for name in code.system.parameters)
    bound = function_of_parameters("bindings", parameters, [("b", bindings(code.system, parameters))])
    p = SX.sym("p", len(parameters))
    return Function("binding_slopes", [p], [jacobian(bound.call([p])[0], p)], ["p"], ["B"], FORWARD)
