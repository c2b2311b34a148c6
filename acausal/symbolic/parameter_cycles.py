"""Parameters that seem to need each other, where a decided `if` needs one of them only.

`T = if given_T then T0 else T_of(h)` beside `h = if given_T then h_of(T) else h0` is no circle when
`given_T` is constant, `final` or evaluated: no run can take the other branches. Where a tunable parameter
decides, it becomes a structural one: to change it is to compile again.
"""

from __future__ import annotations

from dataclasses import replace

from acausal.errors import LookupProblem
from acausal.lang.flat import FlatModel, Variability, Variable
from acausal.symbolic.expressions.construct import rebuild
from acausal.symbolic.expressions.evaluate import EvaluationFailed, NotConstant, evaluate
from acausal.symbolic.expressions.expr import Constant, Expr, fold, symbols
from acausal.symbolic.parameters import definition, order_parameters


def without_cycles(flat: FlatModel) -> FlatModel:
    """The model itself, or with values of parameters in which conditions have chosen their branch.

    Circles that remain are left to whoever orders the parameters. O(size of the definitions).
    """
    if _is_ordered(flat):
        return flat
    for every in (False, True):
        choose = _Choices(flat, every)
        variables = [choose.decided(v) for v in flat.variables]
        opened = replace(
            flat,
            variables=tuple([replace(v, structural=True) if v.name in choose.used else v for v in variables]),
        )
        if _is_ordered(opened):
            return opened
    return flat


def _is_ordered(flat: FlatModel) -> bool:
    try:
        order_parameters(flat)
    except LookupProblem:
        return False
    return True


class _Choices:
    """Conditions by their values: those that no run can change, or those of all parameters (`every`)."""

    def __init__(self, flat: FlatModel, every: bool) -> None:
        self._flat = flat
        self._every = every
        self._busy: set[str] = set()
        self.used: dict[str, None] = {}
        """The parameters that decided something."""

    def decided(self, variable: Variable) -> Variable:
        """A parameter whose value has lost the branches that are never taken."""
        if variable.binding is None or variable.is_unknown:
            return variable
        binding = fold([variable.binding], self._visit)[variable.binding]
        return variable if binding is variable.binding else replace(variable, binding=binding)

    def _visit(self, node: Expr, args: list[Expr]) -> Expr:
        if node.op == "if":
            known = self._known(args[0])
            if known is not None:
                return args[1] if known else args[2]
        new = tuple(args)
        return node if new == node.args else rebuild(node, new)

    def _known(self, condition: Expr) -> Constant | None:
        try:
            known = evaluate(condition, self._value)
        except (NotConstant, EvaluationFailed):
            return None
        self.used.update(dict.fromkeys(symbols([condition])))
        return known

    def _value(self, name: str) -> Constant | None:
        """The value of what no run can change; None for everything else."""
        variable = self._flat.by_name.get(name)
        if variable is None or variable.is_unknown or name in self._busy:
            return None
        if not (self._every or _is_closed(variable)):
            return None
        expr = definition(variable)
        if expr is None or not variable.is_fixed:
            return None
        self._busy.add(name)
        try:
            return self._known(expr)
        finally:
            self._busy.discard(name)


def _is_closed(variable: Variable) -> bool:
    return variable.variability is Variability.CONSTANT or variable.final or variable.structural
