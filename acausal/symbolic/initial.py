"""The initial problem: values of everything at the start time, from equations and start values.

Unknown are all leaves of the extended system, the parameters with `fixed = false` and those whose bindings
depend on them; known are time and the other parameters. Conditions are taken in this order, each only if the
unknowns still have room for it:

1. all equations, differentiated ones included, and the bindings of dependent parameters;
2. initial equations, then `x = start` for every `fixed = true`; where there is no room they become `checks`,
   because whether they contradict the rest can only be decided by numbers;
3. as many `x = start` of unfixed variables as are still needed (reason `assumed`): states first, then other
   differentiated variables, then parameters, then variables with a start value, then the rest; among equals
   those with a start value, then few dots, then declaration order.

"Room" means that a matching of conditions with unknowns can be extended (a matroid, so the greedy order gives
the best set). Modelica's default start is 0, false, or the nearest value between min and max.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from acausal.errors import Diagnostic, InitializationProblem
from acausal.lang.flat import Equation, Origin, Variable
from acausal.symbolic.attributes import start_or_default, start_place
from acausal.symbolic.blocks import NoCompleteMatching, ordered_blocks, rows, square_system
from acausal.symbolic.causal import (
    Assignment,
    Block,
    BlockKind,
    CausalEquation,
    InitialCondition,
    InitialConflict,
    InitialProblem,
    InitialValue,
    Residual,
)
from acausal.symbolic.describe import dots, equation_with_place, leaf_texts, listed
from acausal.symbolic.expressions.expr import Expr, const, sub, sym
from acausal.symbolic.expressions.text import to_text
from acausal.symbolic.graphs.dulmage_mendelsohn import overdetermined_subset
from acausal.symbolic.graphs.matching import Matcher
from acausal.symbolic.graphs.types import Eq, Var
from acausal.symbolic.index_reduction import Reduced
from acausal.symbolic.parameters import definition, dependent_parameters, free_parameters
from acausal.symbolic.solving import Profiler


@dataclass(frozen=True)
class _Start:
    """`x = start` of one variable."""

    variable: Variable
    value: Expr
    reason: str

    def equation(self) -> CausalEquation:
        left = sym(self.variable.name)
        return CausalEquation(left, self.value, Equation(left, self.value, start_place(self.variable)))

    def condition(self) -> InitialCondition:
        return InitialCondition(self.equation(), self.variable.name)

    def report(self) -> InitialValue:
        return InitialValue(self.variable.name, self.value, self.reason)


def initial_problem(
    reduced: Reduced, states: Sequence[str], dynamic: Sequence[Block], profiler: Profiler
) -> InitialProblem:
    """Build the initial problem (see the module's text); near-linear.

    `dynamic` are the blocks of the running system: where exactly the states get start values they are used
    again as they are. Raises InitializationProblem `initial.singular`.
    """
    fixed = [
        _Start(v, start_or_default(v, reduced.model.values), "fixed")
        for v in reduced.model.unknowns
        if v.fixed
    ]
    if not reduced.model.initial_equations and not _free_parameters(reduced):
        simple = _from_states(reduced, states, dynamic, fixed)
        if simple is not None:
            return simple
    return _general(reduced, states, fixed, profiler)


def _free_parameters(reduced: Reduced) -> list[Variable]:
    return list(free_parameters(reduced.model.flat))


def _bindings(reduced: Reduced) -> list[CausalEquation]:
    """`q = binding` of the parameters that depend on free ones."""
    found: list[CausalEquation] = []
    for variable in dependent_parameters(reduced.model.flat, reduced.model.values.order):
        value = definition(variable)
        assert value is not None  # what depends on something has a value
        left = sym(variable.name)
        flat = Equation(left, value, variable.span, variable.name.rpartition(".")[0], Origin.BINDING)
        found.append(CausalEquation(left, value, flat))
    return found


def _from_states(
    reduced: Reduced, states: Sequence[str], dynamic: Sequence[Block], fixed: list[_Start]
) -> InitialProblem | None:
    """The usual case: every state starts at its start value, and nothing else is prescribed."""
    by_name = reduced.model.flat.by_name
    chosen = set(states)
    if any(start.variable.name not in chosen for start in fixed) or any(
        name not in by_name for name in states
    ):
        return None
    starts = [_state_start(by_name[name], reduced) for name in states]
    assigned = [
        Block(BlockKind.EXPLICIT, (Assignment(sym(s.variable.name), s.value, s.equation()),)) for s in starts
    ]
    blocks = (*assigned, *dynamic)
    values = (*[s.report() for s in starts], *_guesses(reduced, blocks, {s.variable.name for s in starts}))
    return InitialProblem(blocks, values, needed=len(starts), unused=_unused(reduced, values))


def _unused(reduced: Reduced, values: Sequence[InitialValue]) -> tuple[str, ...]:
    used = {value.name for value in values}
    return tuple(v.name for v in reduced.model.unknowns if v.start is not None and v.name not in used)


def _state_start(variable: Variable, reduced: Reduced) -> _Start:
    value = start_or_default(variable, reduced.model.values)
    return _Start(variable, value, "fixed" if variable.fixed else "assumed")


MOST_EXPLAINED = 100
"""Surplus conditions whose competitors are looked for; each costs one search."""
MOST_GIVEN = 10
"""Equations of the model that a surplus condition keeps as its reason."""


class _Conditions:
    """Which conditions the unknowns have room for: a matching that grows."""

    def __init__(self, given: Sequence[CausalEquation], unknowns: Sequence[Expr], profiler: Profiler) -> None:
        self.given = tuple(given)
        self.used = list(given)
        self.taken: list[InitialCondition] = []
        self.surplus: list[InitialCondition] = []
        self._profiler = profiler
        self._index = {leaf: Var(i) for i, leaf in enumerate(unknowns)}
        self._matcher = Matcher([self._row(e) for e in given], len(unknowns))
        self._matcher.augment([Eq(i) for i in range(len(given))])
        self._of: dict[Eq, InitialCondition] = {}

    @property
    def complete(self) -> bool:
        return len(self.used) == len(self._index)

    def _row(self, equation: CausalEquation) -> list[Var]:
        return rows(self._profiler.profile(equation), self._index)

    def add(self, condition: InitialCondition, *, must: bool = True) -> bool:
        """Take the condition if there is room; a condition that `must` hold becomes a check otherwise."""
        number = self._matcher.add_equation(self._row(condition.equation))
        fits = not self._matcher.augment([number])
        if fits:
            self.used.append(condition.equation)
            self.taken.append(condition)
        elif must:
            self.surplus.append(condition)
        if fits or must:
            self._of[number] = condition
        return fits

    def conflicts(self) -> tuple[InitialConflict, ...]:
        """For the first surplus conditions the others of the smallest set that is one too many."""
        if not self.surplus:
            return ()
        matching = self._matcher.freeze()
        numbers = {id(condition): number for number, condition in self._of.items()}
        found: list[InitialConflict] = []
        for condition in self.surplus[:MOST_EXPLAINED]:
            part = overdetermined_subset(self._matcher.rows, matching, numbers[id(condition)])
            others = [self._of[eq] for eq in part.equations if eq in self._of]
            given = [eq for eq in part.equations if eq not in self._of]
            given.sort(key=lambda eq: len(self._matcher.rows[eq]))  # what prescribes one quantity first
            found.append(
                InitialConflict(
                    condition,
                    tuple(o for o in others if o is not condition),
                    tuple(self.given[eq] for eq in given[:MOST_GIVEN]),
                )
            )
        return tuple(found)


def _general(
    reduced: Reduced, states: Sequence[str], fixed: list[_Start], profiler: Profiler
) -> InitialProblem:
    bindings = _bindings(reduced)
    given = [*reduced.equations, *bindings]
    unknowns = [
        *reduced.leaves,
        *(sym(v.name) for v in _free_parameters(reduced)),
        *(binding.left for binding in bindings),
    ]
    conditions = _Conditions(given, unknowns, profiler)
    for equation in reduced.model.initial_equations:
        conditions.add(InitialCondition(equation))
    equations = len(conditions.taken)
    for start in fixed:
        conditions.add(start.condition())
    values = [start.report() for start in fixed]
    for start in _assumable(reduced, states):
        if conditions.complete:
            break
        if conditions.add(start.condition(), must=False):
            values.append(start.report())
    blocks = _ordered(reduced, conditions.used, unknowns, profiler)
    reported = (*values, *_guesses(reduced, blocks, {value.name for value in values}))
    return InitialProblem(
        blocks,
        reported,
        tuple(Residual(sub(c.equation.left, c.equation.right), c.equation) for c in conditions.surplus),
        needed=len(unknowns) - len(given),
        equations=equations,
        conflicts=conditions.conflicts(),
        unused=_unused(reduced, reported),
    )


def _assumable(reduced: Reduced, states: Sequence[str]) -> list[_Start]:
    """Unfixed variables in the order in which their start values are used."""
    chosen = set(states)
    moving = {
        to_text(reduced.leaves[i])
        for i, high in enumerate(reduced.reduction.derivative_of)
        if high is not None
    }
    position = {v.name: i for i, v in enumerate(reduced.model.flat.variables)}
    parameters = _free_parameters(reduced)

    def key(variable: Variable) -> tuple[bool, bool, bool, bool, int, int]:
        name, start = variable.name, variable.start is not None
        other = name not in chosen and name not in moving and variable.is_unknown
        return name not in chosen, name not in moving, other, not start, dots(name), position[name]

    free = [v for v in (*reduced.model.unknowns, *parameters) if v.fixed is not True]
    free.sort(key=key)
    return [_Start(v, _parameter_start(v, reduced), "assumed") for v in free]


def _parameter_start(variable: Variable, reduced: Reduced) -> Expr:
    if variable.binding is not None and variable.start is None:
        return variable.binding
    return start_or_default(variable, reduced.model.values)


def _ordered(
    reduced: Reduced, used: list[CausalEquation], unknowns: list[Expr], profiler: Profiler
) -> tuple[Block, ...]:
    try:
        square = square_system([profiler.profile(e) for e in used], unknowns)
    except NoCompleteMatching as problem:
        matching = problem.square.matching
        free = [unknowns[var] for var in matching.unmatched_variables()]
        surplus = [used[eq] for eq in matching.unmatched_equations()]
        raise _singular(reduced, free, surplus) from None
    return ordered_blocks(square)


def _singular(reduced: Reduced, free: list[Expr], surplus: list[CausalEquation]) -> InitializationProblem:
    names = leaf_texts(free)
    what = (
        f"the initial system does not determine {listed(names)}"
        if names
        else "the initial system is singular"
    )
    because = (
        "; too many conditions: " + listed([equation_with_place(e.flat) for e in surplus]) if surplus else ""
    )
    spans = [e.flat.span for e in surplus] or [
        reduced.model.flat.by_name[n].span for n in names if n in reduced.model.flat.by_name
    ]
    hint = "give it a start value with fixed = true, or an initial equation"
    span = spans[0] if spans else reduced.model.flat.span
    return InitializationProblem(Diagnostic("initial.singular", what + because, span, names, hint))


def _guesses(reduced: Reduced, blocks: Sequence[Block], known: set[str]) -> tuple[InitialValue, ...]:
    """Where iteration starts: the start values of tearing variables of nonlinear blocks."""
    by_name = reduced.model.flat.by_name
    guesses: list[InitialValue] = []
    for block in blocks:
        if block.kind is not BlockKind.NONLINEAR:
            continue
        for leaf in block.tearing:
            name = to_text(leaf)
            variable = by_name.get(name) if leaf.op == "sym" else None
            start = const(0.0) if variable is None else start_or_default(variable, reduced.model.values)
            if name not in known:
                guesses.append(InitialValue(name, start, "guess"))
    return tuple(guesses)
