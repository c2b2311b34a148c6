"""Discrete variables at the start: their values and those before it, `v` and `pre(v)` (Modelica 3.6, 8.6).

Conditions are taken in this order, each as far as an unknown is left for it: the definitions (when-clauses
that do not fire at the start say `v = pre(v)`), initial equations, `pre(v) = start` of `fixed = true`, then
the same of all others (reason `assumed`).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from acausal.errors import Diagnostic, InitializationProblem
from acausal.lang.flat import Equation
from acausal.symbolic.attributes import same_value, start_or_default
from acausal.symbolic.causal import Assignment, CausalEquation, DiscretePart, InitialValue
from acausal.symbolic.describe import equation_with_place
from acausal.symbolic.discrete import Divided, in_order
from acausal.symbolic.expressions import expr as ex
from acausal.symbolic.expressions.expr import Expr
from acausal.symbolic.graphs.matching import Matcher
from acausal.symbolic.graphs.types import Eq, Var
from acausal.symbolic.leaves import all_leaves


@dataclass(frozen=True)
class DiscreteStart:
    """`assignments` in order, and which start values they use."""

    assignments: tuple[Assignment, ...]
    values: tuple[InitialValue, ...]


def discrete_start(divided: Divided, part: DiscretePart) -> DiscreteStart:
    """The initial problem of the discrete variables. Near-linear.

    Raises InitializationProblem `initial.discrete-overdetermined`.
    """
    variables = dict.fromkeys(divided.variables)
    past = [node for node in part.memory if node.args[0] in variables]
    work = _Start([*variables, *past], part.memory)
    for definition in divided.definitions:
        work.add(definition.equation, definition.unknown, definition.value)
    surplus = [e for e in divided.initial if not work.add(e, e.left, e.right)]
    given = {a.unknown: a.value for a in work.assignments()}
    wrong = [e for e in surplus if not _is_repeated(e, given, divided)]
    if wrong:
        raise _overdetermined(wrong)
    values: list[InitialValue] = []
    for wanted, reason in ((True, "fixed"), (False, "assumed")):
        for node in past:
            variable = divided.continuous.flat.by_name[node.args[0].name]
            start = start_or_default(variable, divided.continuous.values)
            equation = CausalEquation(node, start, Equation(node, start, variable.span))
            if bool(variable.fixed) is wanted and work.add(equation, node, start):
                values.append(InitialValue(variable.name, start, reason))
    held = [a for a in part.assignments if a.unknown.op == "integer"]
    return DiscreteStart(in_order([*work.assignments(), *held]), tuple(values))


def _is_repeated(equation: CausalEquation, given: Mapping[Expr, Expr], divided: Divided) -> bool:
    """Whether an equation says again what another one says; `pre` of aliases is one and the same value."""
    for leaf, value in ((equation.left, equation.right), (equation.right, equation.left)):
        if leaf in given:
            equal = same_value(given[leaf], value, divided.continuous.values)
            return equal if equal is not None else leaf.op == "pre"
    return False


class _Start:
    """Which condition determines what, so far."""

    def __init__(self, unknowns: Sequence[Expr], memory: Sequence[Expr]) -> None:
        self._unknowns = list(unknowns)
        self._index = {leaf: Var(i) for i, leaf in enumerate(unknowns)}
        self._matcher = Matcher([], len(unknowns))
        self._conditions: list[tuple[CausalEquation, Expr, Expr]] = []
        self._memo = {ex.initial(): ex.TRUE, **{node: node for node in memory}}

    def add(self, equation: CausalEquation, left: Expr, right: Expr) -> bool:
        """Takes `left = right` if an unknown is left for it."""
        sides = [ex.substitute(side, {}, self._memo) for side in (left, right)]
        row = [
            self._index[a] for a, b in (sides, sides[::-1]) if a in self._index and a not in all_leaves([b])
        ]
        if self._matcher.augment([self._matcher.add_equation(row)]):
            return False
        self._conditions.append((equation, sides[0], sides[1]))
        return True

    def assignments(self) -> list[Assignment]:
        """Every condition that was taken, solved for its unknown."""
        found: list[Assignment] = []
        taken = [eq for eq, var in enumerate(self._matcher.var_of_eq) if var is not None]
        for eq, (equation, left, right) in zip(taken, self._conditions, strict=True):
            var = self._matcher.var_of_eq[Eq(eq)]
            assert var is not None
            unknown = self._unknowns[var]
            found.append(Assignment(unknown, right if unknown is left else left, equation))
        return found


def _overdetermined(surplus: Sequence[CausalEquation]) -> InitializationProblem:
    return InitializationProblem(
        [
            Diagnostic(
                "initial.discrete-overdetermined",
                f"nothing is left for the initial equation {equation_with_place(e.flat)} to determine",
                e.flat.span,
                tuple([leaf.name for leaf in all_leaves([e.flat.left, e.flat.right]) if leaf.op == "sym"]),
                "remove it, or a start value with fixed = true",
            )
            for e in surplus
        ]
    )
