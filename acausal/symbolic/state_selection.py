"""State selection by dummy derivatives, with numeric pivoting at the start values.

Mattsson and Soederlind, "Index reduction in differential-algebraic equations using dummy derivatives", SIAM J.
Sci. Comput. 14 (1993): for every differentiated equation one derivative becomes a dummy, an algebraic unknown;
the variable below it is no state. They choose within the blocks of the highest derivatives; here the choice is
among all derivatives that a connected set of constraints holds, which allows more: with m = rho(p)*V either
the mass or the pressure can be the state, though der(m) follows from the flows alone. It is enough that on
every level the constraints can be solved for the chosen variables, since their derivatives are unknown anyway.

Those become dummies that are worth least as states, as long as the constraints can be solved for them
(`pivoting`). Worth, the first difference deciding:

1. `stateSelect`: always, prefer, default, avoid, never;
2. a choice that is valid everywhere (constant pivots) goes before one that depends on the state;
3. `fixed = true`, then an explicit start value;
4. fewer dots in the name, then declared first.

A speed and its angle count together. The Jacobian is evaluated at start values; where none is given, at a
number that depends only on the variable's position, so that a default start of zero does not hide a
coefficient.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from acausal.errors import Diagnostic, fail
from acausal.lang.flat import StateSelect, Variable
from acausal.symbolic.causal import CausalEquation, StateChoice
from acausal.symbolic.describe import ReductionProblem, base_name, dots, equation_with_place, listed
from acausal.symbolic.expressions.evaluate import EvaluationFailed, NotConstant, evaluate
from acausal.symbolic.expressions.expr import TIME, Constant, Expr, sub
from acausal.symbolic.expressions.linear import slopes
from acausal.symbolic.expressions.text import to_text
from acausal.symbolic.graphs.types import Eq, Var
from acausal.symbolic.index_reduction import Reduced
from acausal.symbolic.leaves import all_leaves
from acausal.symbolic.pivoting import Column, Entry, independent_columns


@dataclass(frozen=True)
class SelectedStates:
    """The outcome: leaves, in declaration order of their variables."""

    states: tuple[Expr, ...]
    dummies: tuple[Expr, ...]
    choices: tuple[StateChoice, ...]


def select_states(reduced: Reduced) -> SelectedStates:
    """Choose states and dummy derivatives; near-linear for local constraints.

    Raises ReductionProblem `reduction.redundant-constraints` where differentiated constraints are dependent,
    and `states.always-impossible` where a variable with `stateSelect = always` cannot be a state.
    """
    chooser = _Chooser(reduced)
    dummies: set[Var] = set()
    for equations in _constraint_sets(reduced):
        dummies.update(chooser.dummies(equations))
    higher = reduced.reduction.derivative_of
    states = tuple(
        leaf
        for leaf, high in zip(reduced.leaves, higher, strict=True)
        if high is not None and high not in dummies
    )
    _check_always(reduced, states, chooser)
    return SelectedStates(
        _in_order(reduced, states),
        tuple(leaf for i, leaf in enumerate(reduced.leaves) if Var(i) in dummies),
        _explain(reduced, states, chooser),
    )


def _constraint_sets(reduced: Reduced) -> list[list[Eq]]:
    """The highest differentiated equations, those together that share highest derivatives; ascending."""
    reduction = reduced.reduction
    original = len(reduction.differentiations)
    derived = [
        Eq(i) for i in range(original, len(reduction.incidence)) if reduction.equation_derivative[i] is None
    ]
    parent = {eq: eq for eq in derived}

    def find(eq: Eq) -> Eq:
        while parent[eq] != eq:
            parent[eq] = eq = parent[parent[eq]]
        return eq

    first: dict[Var, Eq] = {}
    for eq in derived:
        for var in reduction.incidence[eq]:
            if reduction.derivative_of[var] is None:
                parent[find(eq)] = find(first.setdefault(var, eq))
    sets: dict[Eq, list[Eq]] = {}
    for eq in derived:
        sets.setdefault(find(eq), []).append(eq)
    return list(sets.values())


def _in_order(reduced: Reduced, states: tuple[Expr, ...]) -> tuple[Expr, ...]:
    """In declaration order of the variables, a variable before its derivatives."""
    position = {v.name: i for i, v in enumerate(reduced.model.flat.variables)}
    return tuple(sorted(states, key=lambda leaf: position[base_name(leaf)]))


Worth = tuple[int, bool, bool, int]
"""stateSelect, fixed, with a start value, minus the number of dots: larger is better as a state."""


def worth(chain: Sequence[Expr], reduced: Reduced) -> Worth:
    """How much a variable and its integrals (a speed and its angle) are worth as states.

    What is given for any of them counts: the highest stateSelect above default, else the lowest.
    """
    variables = [
        variable
        for leaf in chain
        if leaf.op == "sym" and (variable := reduced.model.flat.by_name.get(leaf.name)) is not None
    ]
    selects = [v.state_select for v in variables]
    highest = max(selects, default=StateSelect.DEFAULT)
    select = highest if highest > StateSelect.DEFAULT else min(selects, default=StateSelect.DEFAULT)
    fixed = any(v.fixed is True for v in variables)
    start = any(v.start is not None for v in variables)
    return select, fixed, start, -dots(base_name(chain[-1]))


class _Chooser:
    """Picks dummies for one block after another and remembers why."""

    def __init__(self, reduced: Reduced) -> None:
        self.reduced = reduced
        self.decisions: dict[Expr, tuple[tuple[Expr, ...], tuple[CausalEquation, ...]]] = {}
        """Per dummy: the leaves it competed with, and the constraints."""
        derivatives = reduced.reduction.equation_derivative
        self._integral = {d: i for i, d in enumerate(reduced.reduction.derivative_of) if d is not None}
        self._eq_integral = {d: Eq(i) for i, d in enumerate(derivatives) if d is not None}
        self._values = _start_values(reduced)
        self._memo: dict[Expr, Constant] = {}
        self._slopes: dict[Eq, dict[Expr, Expr | None]] = {}

    def dummies(self, equations: list[Eq]) -> list[Var]:
        """The dummies of one set of constraints, from its highest level of differentiation down."""
        reduction = self.reduced.reduction
        held = {var: None for eq in equations for var in reduction.incidence[eq]}
        candidates = [var for var in held if reduction.derivative_of[var] is None]
        dummies: list[Var] = []
        while equations:
            candidates = sorted(candidates)
            chosen = self._choose(equations, candidates)
            dummies += chosen
            lower = (self._eq_integral.get(eq) for eq in equations)
            equations = sorted(eq for eq in lower if eq is not None and eq in self._eq_integral)
            candidates = [Var(self._integral[var]) for var in chosen]
        return dummies

    def _choose(self, equations: Sequence[Eq], candidates: Sequence[Var]) -> list[Var]:
        """Of the candidates as many as equations, so that the equations can be solved for them."""
        picked = independent_columns(
            self._columns(equations, candidates), self._groups(candidates), len(equations)
        )
        if len(picked) < len(equations):
            raise self._dependent(equations)
        chosen = sorted(candidates[i] for i in picked)
        self._remember(equations, candidates, chosen)
        return chosen

    def chain(self, var: int) -> list[Expr]:
        """A variable's leaf and those of its integrals."""
        chain = [self.reduced.leaves[var]]
        while (lower := self._integral.get(Var(var))) is not None:
            chain.append(self.reduced.leaves[lower])
            var = lower
        return chain

    def _groups(self, candidates: Sequence[Var]) -> list[list[int]]:
        """Candidates from least to most worth as states, in groups of equal stateSelect."""
        keys = [worth(self.chain(self._integral[var]), self.reduced) for var in candidates]
        order = sorted(range(len(keys)), key=lambda i: (*keys[i], -candidates[i]))
        groups: dict[int, list[int]] = {}
        for i in order:
            groups.setdefault(keys[i][0], []).append(i)
        return list(groups.values())

    def _columns(self, equations: Sequence[Eq], candidates: Sequence[Var]) -> list[Column]:
        columns: list[dict[int, Entry]] = [{} for _ in candidates]
        position = {self.reduced.leaves[var]: i for i, var in enumerate(candidates)}
        for row, eq in enumerate(equations):
            for leaf, coefficient in self._equation_slopes(eq).items():
                if leaf in position and coefficient is not None:
                    entry = self._entry(coefficient)
                    if entry.value != 0:
                        columns[position[leaf]][row] = entry
        return list(columns)

    def _equation_slopes(self, eq: Eq) -> dict[Expr, Expr | None]:
        if eq not in self._slopes:
            equation = self.reduced.equations[eq]
            self._slopes[eq] = residual_slopes(equation)
        return self._slopes[eq]

    def _entry(self, coefficient: Expr) -> Entry:
        number = self.reduced.model.values.number(coefficient)
        if number is not None:
            return Entry(number, True)
        for leaf in all_leaves([coefficient]):
            if leaf not in self._memo:
                self._memo[leaf] = self._values.get(leaf, _pseudo(len(self._memo)))
        try:
            value = evaluate(coefficient, self.reduced.model.values.lookup, self._memo)
        except (EvaluationFailed, NotConstant):
            return Entry(1.0, False)
        return Entry(float(value) if isinstance(value, int | float) else 1.0, False)

    def _dependent(self, equations: Sequence[Eq]) -> ReductionProblem:
        involved = [self.reduced.equations[eq] for eq in equations]
        names = dict.fromkeys(
            base_name(leaf) for e in involved for leaf in all_leaves([e.flat.left, e.flat.right])
        )
        texts = dict.fromkeys(equation_with_place(e.flat) for e in involved)
        error = fail(
            ReductionProblem,
            "reduction.redundant-constraints",
            f"these constraints are not independent: {listed(list(texts))}",
            involved[0].flat.span,
            names=names,
            hint="one of them follows from the others (a closed loop of rigid connections?): remove it, "
            "or make one connection elastic",
        )
        return ReductionProblem(error.diagnostics)

    def _remember(self, equations: Sequence[Eq], candidates: Sequence[Var], chosen: Sequence[Var]) -> None:
        leaves = self.reduced.leaves
        competitors = tuple(leaves[self._integral[v]] for v in candidates if v not in set(chosen))
        constraints = tuple(self.reduced.equations[eq] for eq in equations)
        for var in chosen:
            self.decisions.setdefault(leaves[self._integral[var]], (competitors, constraints))


def residual_slopes(equation: CausalEquation) -> dict[Expr, Expr | None]:
    """Coefficients of `left - right` (see `linear.slopes`)."""
    return slopes(sub(equation.left, equation.right))


def _pseudo(position: int) -> float:
    """A number between 0.3 and 0.9 that differs from variable to variable (multiples of the golden ratio)."""
    return 0.3 + 0.6 * ((position + 1) * 0.6180339887498949 % 1.0)


def _start_values(reduced: Reduced) -> dict[Expr, Constant]:
    """Leaves with a given start value, and the start time."""
    values = reduced.model.values
    known: dict[Expr, Constant] = {TIME: reduced.model.flat.experiment.start_time or 0.0}
    by_name = reduced.model.flat.by_name
    for position, leaf in enumerate(reduced.leaves):
        variable = by_name.get(leaf.name) if leaf.op == "sym" else None
        start = None if variable is None or variable.start is None else values.constant(variable.start)
        known[leaf] = _pseudo(position) if start is None else start
    return known


def _check_always(reduced: Reduced, states: tuple[Expr, ...], chooser: _Chooser) -> None:
    chosen = {to_text(leaf) for leaf in states}
    members = {a.name: a for a in reduced.model.aliases}
    problems: list[Diagnostic] = []
    for variable in reduced.model.flat.variables:
        if (
            variable.state_select is not StateSelect.ALWAYS
            or variable.name in chosen
            or not variable.is_unknown
        ):
            continue
        alias = members.get(variable.name)
        if alias is not None and alias.value.op != "const" and _is_signed_state(alias.value, chosen):
            continue
        problems.append(_always_impossible(variable, reduced, chooser))
    if problems:
        raise ReductionProblem(problems)


def _is_signed_state(value: Expr, states: set[str]) -> bool:
    inner = value.args[0] if value.op == "neg" else value
    return inner.op == "sym" and inner.name in states


def _always_impossible(variable: Variable, reduced: Reduced, chooser: _Chooser) -> Diagnostic:
    decision = next((d for leaf, d in chooser.decisions.items() if to_text(leaf) == variable.name), None)
    alias = next((a for a in reduced.model.aliases if a.name == variable.name), None)
    if alias is not None:
        because = f"it equals {to_text(alias.value)} by {equation_with_place(alias.equation)}"
    elif decision is not None:
        because = "it is constrained by " + listed([equation_with_place(e.flat) for e in decision[1]])
    else:
        because = "the equations determine it at every instant"
    return Diagnostic(
        "states.always-impossible",
        f"'{variable.name}' has stateSelect = StateSelect.always but cannot be a state: {because}",
        variable.span,
        (variable.name,),
        "use StateSelect.prefer, or remove the constraint",
    )


def _explain(reduced: Reduced, states: tuple[Expr, ...], chooser: _Chooser) -> tuple[StateChoice, ...]:
    chosen = {to_text(leaf): None for leaf in states}
    result: list[StateChoice] = []
    rivals: dict[str, list[str]] = {}
    for leaf, (competitors, _) in chooser.decisions.items():
        for other in competitors:
            rivals.setdefault(to_text(other), []).append(to_text(leaf))
    aliases = {a.name: a for a in reduced.model.aliases}
    for i, higher in enumerate(reduced.reduction.derivative_of):
        if higher is not None:
            name = to_text(reduced.leaves[i])
            reason = _reason(reduced, i, chosen, chooser, rivals)
            result.append(StateChoice(name, name in chosen, reason))
    for name in reduced.model.constrained:
        alias = aliases[name]
        reason = f"equals {to_text(alias.value)} by {equation_with_place(alias.equation)}"
        result.append(StateChoice(name, False, reason))
    return tuple(result)


def _reason(
    reduced: Reduced, i: int, states: dict[str, None], chooser: _Chooser, rivals: dict[str, list[str]]
) -> str:
    leaf = reduced.leaves[i]
    name = to_text(leaf)
    select, fixed, start, _ = worth(chooser.chain(i), reduced)
    if name in states:
        if name not in rivals:
            return "its derivative appears, and no constraint holds it"
        why = (
            f"stateSelect = {StateSelect(select).literal}"
            if select != StateSelect.DEFAULT
            else "a fixed start value"
            if fixed
            else "a start value"
            if start
            else "its place in the model"
        )
        return f"kept over {listed(rivals[name])} for {why}"
    if leaf in chooser.decisions:
        competitors, constraints = chooser.decisions[leaf]
        by = listed([equation_with_place(e.flat) for e in constraints])
        if competitors:
            return f"follows from {listed([to_text(c) for c in competitors])} through {by}"
        return f"fixed by {by}"
    return "the constraints determine it"
