"""State selection by dummy derivatives, with numeric pivoting at a point.

`graphs.dummy_derivatives` says which choices there are; here the choice is made. Those become dummies that
are worth least as states, as long as the constraints can be solved for them (`pivoting`). Worth, the first
difference deciding:

1. `stateSelect`: always, prefer, default, avoid, never;
2. a choice that is valid everywhere (constant pivots) goes before one that depends on the state;
3. `fixed = true`, then an explicit start value;
4. fewer dots in the name, then declared first.

A speed and its angle count together. The Jacobian is evaluated at start values; where none is given, at a
number that depends only on the variable's position, so that a default start of zero does not hide a
coefficient. Columns count in nominal values.

Where a choice depends on the state, `SelectedStates.monitors` says what to watch. When it has become bad,
`select_states` is asked again at the present point: then what is a dummy stays one where that is sound, and
soundness goes before any `stateSelect` but `always`.
"""

from __future__ import annotations

from collections.abc import Container, Mapping, Sequence
from dataclasses import dataclass

from acausal.errors import ReductionProblem, fail
from acausal.lang.flat import StateSelect
from acausal.symbolic.causal import CausalEquation, StateChoice, StateMonitor
from acausal.symbolic.describe import base_name, equation_with_place, listed
from acausal.symbolic.expressions.evaluate import EvaluationFailed, NotConstant, evaluate
from acausal.symbolic.expressions.expr import ONE, TIME, Constant, Expr, const, mul, sub
from acausal.symbolic.expressions.linear import slopes
from acausal.symbolic.expressions.text import to_text
from acausal.symbolic.graphs.dummy_derivatives import select_dummies
from acausal.symbolic.graphs.types import Eq, Var
from acausal.symbolic.index_reduction import Reduced
from acausal.symbolic.leaves import all_leaves
from acausal.symbolic.monitors import Row, state_monitors
from acausal.symbolic.pivoting import Column, Entry, independent_columns
from acausal.symbolic.state_choices import (
    Decision,
    Worth,
    check_always,
    explain_states,
    integral_of,
    integrals,
    worth,
)


@dataclass(frozen=True)
class Point:
    """Where a choice is made: values of leaves and, unless it is the first choice, the states so far."""

    values: Mapping[Expr, Constant]
    states: tuple[str, ...] | None = None


@dataclass(frozen=True)
class SelectedStates:
    """The outcome: leaves, in declaration order of their variables."""

    states: tuple[Expr, ...]
    dummies: tuple[Expr, ...]
    choices: tuple[StateChoice, ...]
    monitors: tuple[StateMonitor, ...] = ()


def select_states(reduced: Reduced, point: Point) -> SelectedStates:
    """Choose states and dummy derivatives; near-linear for local constraints.

    Raises ReductionProblem `reduction.redundant-constraints` where differentiated constraints are dependent,
    and `states.always-impossible` where a variable with `stateSelect = always` cannot be a state.
    """
    chooser = _Chooser(reduced, point)
    selection = select_dummies(reduced.reduction, chooser.choose)
    states = tuple(reduced.leaves[var] for var in selection.states)
    check_always(reduced, states, chooser.decisions)
    return SelectedStates(
        _in_order(reduced, states),
        tuple(reduced.leaves[var] for var in selection.dummies),
        explain_states(reduced, states, chooser.decisions),
        tuple({monitor.relation: monitor for monitor in chooser.monitors}.values()),
    )


def starting_point(reduced: Reduced) -> Point:
    """The start time, and start values as far as the model gives them."""
    values = reduced.model.values
    known: dict[Expr, Constant] = {TIME: reduced.model.flat.experiment.start_time or 0.0}
    by_name = reduced.model.flat.by_name
    for position, leaf in enumerate(reduced.leaves):
        variable = by_name.get(leaf.name) if leaf.op == "sym" else None
        start = None if variable is None or variable.start is None else values.constant(variable.start)
        known[leaf] = _pseudo(position) if start is None else start
    return Point(known)


def _pseudo(position: int) -> float:
    """A number between 0.3 and 0.9 that differs from variable to variable (multiples of the golden ratio)."""
    return 0.3 + 0.6 * ((position + 1) * 0.6180339887498949 % 1.0)


def _in_order(reduced: Reduced, states: tuple[Expr, ...]) -> tuple[Expr, ...]:
    """In declaration order of the variables, a variable before its derivatives."""
    position = {v.name: i for i, v in enumerate(reduced.model.flat.variables)}
    return tuple(sorted(states, key=lambda leaf: position[base_name(leaf)]))


class _Chooser:
    """Picks dummies for one constraint set and level after another, and remembers why."""

    def __init__(self, reduced: Reduced, point: Point) -> None:
        self.reduced = reduced
        self.decisions: dict[Expr, Decision] = {}
        """Per variable that is no state."""
        self.monitors: list[StateMonitor] = []
        self._integral = integral_of(reduced)
        self._states = None if point.states is None else frozenset(point.states)
        self._memo: dict[Expr, Constant] = dict(point.values)
        self._slopes: dict[Eq, dict[Expr, Expr | None]] = {}

    def choose(self, equations: Sequence[Eq], candidates: Sequence[Var]) -> list[Var]:
        """Of the candidates as many as equations, so that the equations can be solved for them."""
        groups = self._groups(candidates)
        soft = 0 if self._states is None else sum(select < StateSelect.ALWAYS for select in groups)
        columns = self._columns(equations, candidates)
        picked = independent_columns(columns, list(groups.values()), len(equations), soft=soft)
        if len(picked) < len(equations):
            raise self._dependent([equations[row] for row in self._rows_without(equations, picked)])
        pivots = {candidates[column]: equations[row] for column, row in picked}
        self._remember(pivots)
        self._watch(pivots)
        return sorted(pivots)

    def _groups(self, candidates: Sequence[Var]) -> dict[int, list[int]]:
        """Candidates from least to most worth as states, by stateSelect in ascending order."""
        keys = [self._worth(var) for var in candidates]
        order = sorted(
            range(len(keys)), key=lambda i: (self._is_state(candidates[i]), *keys[i], -candidates[i])
        )
        groups: dict[int, list[int]] = {}
        for i in order:
            groups.setdefault(keys[i][0], []).append(i)
        return {select: groups[select] for select in sorted(groups)}

    def _is_state(self, var: Var) -> bool:
        """Whether the variable below is a state so far."""
        return self._states is not None and to_text(self.reduced.leaves[self._integral[var]]) in self._states

    def _worth(self, var: Var) -> Worth:
        """What is lost if `var` becomes a dummy."""
        return worth(integrals(self._integral[var], self._integral, self.reduced), self.reduced)

    def _columns(self, equations: Sequence[Eq], candidates: Sequence[Var]) -> list[Column]:
        columns: list[dict[int, Entry]] = [{} for _ in candidates]
        position = {var: i for i, var in enumerate(candidates)}
        for row, eq in enumerate(equations):
            for var, coefficient in self._coefficients(eq, position).items():
                entry = self._entry(coefficient)
                if entry.value != 0:
                    columns[position[var]][row] = entry
        return list(columns)

    def _coefficients(self, eq: Eq, wanted: Container[Var]) -> dict[Var, Expr]:
        """Coefficients of the `wanted` variables in an equation, in nominal values of the variables."""
        if eq not in self._slopes:
            self._slopes[eq] = residual_slopes(self.reduced.equations[eq])
        found: dict[Var, Expr] = {}
        for var in self.reduced.reduction.incidence[eq]:
            coefficient = self._slopes[eq].get(self.reduced.leaves[var]) if var in wanted else None
            if coefficient is not None:
                found[var] = mul(self._nominal(var), coefficient)
        return found

    def _nominal(self, var: Var) -> Expr:
        """The nominal value of the lowest integral, which all its derivatives are taken to share."""
        variable = self.reduced.model.flat.by_name[base_name(self._chain(var)[-1])]
        number = None if variable.nominal is None else self.reduced.model.values.number(variable.nominal)
        return const(abs(number)) if number else ONE

    def _chain(self, var: Var) -> list[Expr]:
        return integrals(var, self._integral, self.reduced)

    def _entry(self, coefficient: Expr) -> Entry:
        constant = self.reduced.model.values.number(coefficient)
        if constant is not None:
            return Entry(constant, True)
        value = self._number(coefficient)
        return Entry(1.0 if value is None else value, False)

    def _number(self, expr: Expr) -> float | None:
        """The value at the point; None where it cannot be computed there."""
        lookup = self.reduced.model.values.lookup
        for leaf in all_leaves([expr]):
            if leaf not in self._memo and (leaf.op != "sym" or lookup(leaf.name) is None):
                self._memo[leaf] = _pseudo(len(self._memo))
        try:
            value = evaluate(expr, lookup, self._memo)
        except (EvaluationFailed, NotConstant):
            return None
        return float(value) if isinstance(value, int | float) else None

    def _rows_without(self, equations: Sequence[Eq], picked: list[tuple[int, int]]) -> list[int]:
        """The dependent rows: those without pivot, and the constraints that share variables with them."""
        incidence = self.reduced.reduction.incidence
        pivoted = {row for _, row in picked}
        free = [row for row in range(len(equations)) if row not in pivoted]
        held = {var for row in free for var in incidence[equations[row]]}
        return [*free, *(row for row in sorted(pivoted) if not held.isdisjoint(incidence[equations[row]]))]

    def _dependent(self, equations: Sequence[Eq]) -> ReductionProblem:
        involved = [self.reduced.equations[eq] for eq in equations]
        names = dict.fromkeys(
            base_name(leaf) for e in involved for leaf in all_leaves([e.flat.left, e.flat.right])
        )
        texts = dict.fromkeys(equation_with_place(e.flat) for e in involved)
        return fail(
            ReductionProblem,
            "reduction.redundant-constraints",
            f"these constraints of the running system are not independent: {listed(list(texts))}",
            involved[0].flat.span,
            names=names,
            hint="one of them follows from the others (a closed loop of rigid connections?): remove it, "
            "or make one connection elastic",
        )

    def _remember(self, pivots: dict[Var, Eq]) -> None:
        """Note for every new dummy the constraint that gives the variable below it, and what it needs."""
        leaves, integral = self.reduced.leaves, self._integral
        for var, eq in pivots.items():
            kept = [other for other in self._same_level(eq) if other not in pivots and other in integral]
            needed = tuple(leaves[integral[other]] for other in kept)
            decision = Decision(needed, self.reduced.equations[eq])
            self.decisions.setdefault(leaves[integral[var]], decision)

    def _watch(self, pivots: dict[Var, Eq]) -> None:
        """Note where the choice of one set and level is good only near the point."""
        rows: list[Row] = []
        for var, eq in pivots.items():
            held = self._coefficients(eq, frozenset(self._same_level(eq)))
            coefficients = {self._below(other): a for other, a in held.items()}
            rows.append(Row(self.reduced.equations[eq], coefficients, self._below(var)))
        number = self.reduced.model.values.number
        self.monitors += state_monitors(rows, lambda a: number(a) is not None, self._number)

    def _below(self, var: Var) -> str:
        """The variable that is a state unless `var` is a dummy."""
        return to_text(self.reduced.leaves[self._integral[var]])

    def _same_level(self, eq: Eq) -> list[Var]:
        """The variables of a constraint, as often integrated as it is from its highest derivative."""
        reduction = self.reduced.reduction
        steps = 0
        while (higher := reduction.equation_derivative[eq]) is not None:
            eq, steps = higher, steps + 1
        variables = [var for var in reduction.incidence[eq] if reduction.derivative_of[var] is None]
        for _ in range(steps):
            variables = [self._integral[var] for var in variables if var in self._integral]
        return variables


def residual_slopes(equation: CausalEquation) -> dict[Expr, Expr | None]:
    """Coefficients of `left - right` (see `linear.slopes`)."""
    return slopes(sub(equation.left, equation.right))
