"""Functions of the parameters alone: parameters from their bindings, start values, nominal values."""

from __future__ import annotations

from collections.abc import Sequence

import casadi as ca
from casadi import SX, Function

from acausal.codegen.casadi_expressions import FORWARD, Converter
from acausal.codegen.scope import column, split
from acausal.lang.flat import STRING
from acausal.symbolic.causal import CausalSystem
from acausal.symbolic.expressions.expr import Expr

_NOT_A_NUMBER = float("nan")


def parameter_function(system: CausalSystem, parameters: tuple[Expr, ...]) -> Function:
    """`(given, override) -> p`; not-a-number for a parameter without a value."""
    given = SX.sym("given", len(parameters))
    override = SX.sym("override", len(parameters))
    convert = Converter({}, {})
    for leaf, value, chosen in zip(parameters, split(given), split(override), strict=True):
        variable = system.flat.by_name[leaf.name]
        default = variable.binding if variable.binding is not None else variable.start
        numeric = default if variable.type != STRING else None
        bound = convert(numeric) if numeric is not None else SX(_NOT_A_NUMBER)
        convert.leaves[leaf] = ca.if_else(chosen, value, bound)
    total = column([convert.leaves[leaf] for leaf in parameters])
    return Function("parameters", [given, override], [total], ["given", "override"], ["p"], FORWARD)


def function_of_parameters(
    name: str, parameters: tuple[Expr, ...], outputs: Sequence[tuple[str, Sequence[Expr | None]]]
) -> Function:
    """`p -> ...`: the values of expressions in parameters; not-a-number for None."""
    p = SX.sym("p", len(parameters))
    convert = Converter(dict(zip(parameters, split(p), strict=True)), {})
    missing = SX(_NOT_A_NUMBER)
    values = [column([missing if root is None else convert(root) for root in roots]) for _, roots in outputs]
    return Function(name, [p], values, ["p"], [output for output, _ in outputs], FORWARD)
