"""`homotopy(actual, simplified)` as a path for the initial problem (Modelica 3.6, 3.7.4.4).

The running system and the initial problem take `actual`. Where the initial problem cannot be solved from its
start values, the model is compiled once more with

    lambda actual + (1 - lambda) simplified

in place of every `homotopy`, `lambda` being a parameter whose value is not used while compiling, so that no
equation is solved by a coefficient that vanishes at one end of the path.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from acausal.lang.flat import REAL, Equation, FlatModel, Variability, Variable
from acausal.symbolic.expressions.expr import ONE, ZERO, Expr, add, fold, mul, rebuild, sub, sym

LAMBDA = "lambda of homotopy"
"""The parameter's name: no Modelica name holds a space outside quotes."""


def blended(flat: FlatModel) -> FlatModel:
    """The model with every `homotopy` as a mixture, and the parameter `LAMBDA` (0 by default). O(nodes)."""
    weight = sym(LAMBDA)
    other = sub(ONE, weight)
    memo: dict[Expr, Expr] = {}

    def visit(node: Expr, args: list[Expr]) -> Expr:
        if node.op == "homotopy":
            return add(mul(weight, args[0]), mul(other, args[1]))
        new = tuple(args)
        return node if new == node.args else rebuild(node, new)

    def mixed(equation: Equation) -> Equation:
        left, right = (fold([side], visit, memo)[side] for side in (equation.left, equation.right))
        same = left is equation.left and right is equation.right
        return equation if same else replace(equation, left=left, right=right)

    parameter = Variable(LAMBDA, REAL, Variability.PARAMETER, flat.span, binding=ZERO)
    return replace(
        flat,
        variables=(*flat.variables, parameter),
        equations=tuple([mixed(equation) for equation in flat.equations]),
        initial_equations=tuple([mixed(equation) for equation in flat.initial_equations]),
    )


def homotopy_equations(flat: FlatModel) -> tuple[Equation, ...]:
    """The equations and initial equations that hold the operator, in order. O(nodes)."""
    memo: dict[Expr, bool] = {}

    def visit(node: Expr, args: list[bool]) -> bool:
        return node.op == "homotopy" or any(args)

    def holds(equation: Equation) -> bool:
        found: Mapping[Expr, bool] = fold([equation.left, equation.right], visit, memo)
        return found[equation.left] or found[equation.right]

    return tuple(e for e in (*flat.equations, *flat.initial_equations) if holds(e))
