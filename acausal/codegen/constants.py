"""Functions of the parameters alone: parameters from their bindings, start values, nominal values."""

from __future__ import annotations

from collections.abc import Sequence

import casadi as ca
from casadi import SX, Function

from acausal.codegen.casadi_expressions import FORWARD, Converter
from acausal.codegen.scope import column, split
from acausal.lang.flat import STRING
from acausal.symbolic.causal import CausalSystem
from acausal.symbolic.expressions.expr import Expr, substitute
from acausal.symbolic.parameters import definition

_NOT_A_NUMBER = float("nan")


def parameter_function(system: CausalSystem, parameters: tuple[Expr, ...]) -> Function:
    """`(given, override) -> p`; not-a-number for a parameter without a value."""
    given = SX.sym("given", len(parameters))
    override = SX.sym("override", len(parameters))
    convert = Converter({}, {})
    defaults = bindings(system, parameters)
    for leaf, value, chosen, default in zip(parameters, split(given), split(override), defaults, strict=True):
        bound = convert(default) if default is not None else SX(_NOT_A_NUMBER)
        convert.leaves[leaf] = ca.if_else(chosen, value, bound)
    total = column([convert.leaves[leaf] for leaf in parameters])
    return Function("parameters", [given, override], [total], ["given", "override"], ["p"], FORWARD)


def bindings(system: CausalSystem, parameters: tuple[Expr, ...]) -> list[Expr | None]:
    """What gives each parameter its value, in terms of numbers: Strings are put in; None for themselves."""
    texts: dict[Expr, Expr] = {}
    found: list[Expr | None] = []
    for leaf in parameters:
        variable = system.flat.by_name[leaf.name]
        value = definition(variable)
        if value is not None and texts:
            value = substitute(value, texts)
        if variable.type == STRING and value is not None and value.op == "const":
            texts[leaf] = value
        found.append(None if variable.type == STRING else value)
    return found


def function_of_parameters(
    name: str, parameters: tuple[Expr, ...], outputs: Sequence[tuple[str, Sequence[Expr | None]]]
) -> Function:
    """`p -> ...`: the values of expressions in parameters; not-a-number for None."""
    p = SX.sym("p", len(parameters))
    convert = Converter(dict(zip(parameters, split(p), strict=True)), {})
    missing = SX(_NOT_A_NUMBER)
    values = [column([missing if root is None else convert(root) for root in roots]) for _, roots in outputs]
    return Function(name, [p], values, ["p"], [output for output, _ in outputs], FORWARD)
