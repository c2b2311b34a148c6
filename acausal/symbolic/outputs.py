"""Removal of what chosen outputs do not need: the smallest part of a model that determines them by itself.

With derivatives counted as their variable, every equation is matched with the variable that it determines. A
variable needs everything in its equation; a when-clause is one equation for all that it assigns, and a
variable that it reinitialises needs it too. What the outputs need in this way, however far away, is a model
of its own with as many equations as unknowns: it can be simulated alone and gives the same values.

The start reaches further, so these are kept with all that they need:

- initial equations that hold anything that is kept;
- equations and initial equations that hold a parameter which only the start determines (`fixed = false`), if
  that parameter is kept, or one that depends on it;
- a continuous variable with `fixed = true` that is no state of its own (its equation does not hold its
  derivative) and depends on anything that is kept: its start value determines a kept one.

Clauses with `terminate` end the run and are kept. An assertion is kept if everything in it is; it does not
keep anything itself. Parameters and inputs are always kept. O(nodes), but for the matching.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from difflib import get_close_matches
from typing import TypeVar

from acausal.errors import Diagnostic, UsageProblem
from acausal.lang.flat import Assertion, Equation, FlatModel, Variability, Variable, When
from acausal.symbolic.balance import check_balance, determining_equations
from acausal.symbolic.describe import base_name
from acausal.symbolic.expressions.expr import Expr, symbols
from acausal.symbolic.graphs.matching import Matcher
from acausal.symbolic.graphs.types import Eq, Var
from acausal.symbolic.leaves import all_leaves, determined
from acausal.symbolic.parameters import dependent_parameters, free_parameters, order_parameters
from acausal.symbolic.structure import structure

_T = TypeVar("_T")


@dataclass(frozen=True)
class Removed:
    """What is not there any more, in the model's order, because the `outputs` do not need it."""

    outputs: tuple[str, ...]
    variables: tuple[Variable, ...] = ()
    equations: tuple[Equation, ...] = ()
    initial_equations: tuple[Equation, ...] = ()
    assertions: tuple[Assertion, ...] = ()
    whens: tuple[When, ...] = ()

    @property
    def equation_count(self) -> int:
        """Scalar equations, those of when-clauses included."""
        return len(self.equations) + sum(len(when.assigned) for when in self.whens)


def keep_for_outputs(flat: FlatModel, outputs: Sequence[str]) -> tuple[FlatModel, Removed]:
    """The part of the model that determines `outputs` (names, or `der(name)`), and what is left out.

    Raises UsageProblem `outputs.unknown-name` and what `check_balance` raises.
    """
    wanted = _base_names(flat, outputs)
    check_balance(flat)
    kept = _Closure(flat).of(wanted)

    def stays(roots: Iterable[Expr]) -> bool:
        return all(kept.has(name) for name in symbols(roots))

    equations = [stays((e.left, e.right)) for e in flat.equations]
    initial = [stays((e.left, e.right)) for e in flat.initial_equations]
    assertions = [stays((a.condition,)) for a in flat.assertions]
    whens = [stays(_when_roots(when)) for when in flat.whens]
    variables = [kept.has(v.name) for v in flat.variables]
    return replace(
        flat,
        variables=_where(flat.variables, variables),
        equations=_where(flat.equations, equations),
        initial_equations=_where(flat.initial_equations, initial),
        assertions=_where(flat.assertions, assertions),
        whens=_where(flat.whens, whens),
    ), Removed(
        tuple(outputs),
        _where(flat.variables, variables, False),
        _where(flat.equations, equations, False),
        _where(flat.initial_equations, initial, False),
        _where(flat.assertions, assertions, False),
        _where(flat.whens, whens, False),
    )


def _where(items: Sequence[_T], marks: Sequence[bool], which: bool = True) -> tuple[_T, ...]:
    return tuple(item for item, mark in zip(items, marks, strict=True) if mark is which)


def _base_names(flat: FlatModel, outputs: Sequence[str]) -> list[str]:
    """The variables behind the outputs, each of which must exist."""
    found: list[str] = []
    problems: list[Diagnostic] = []
    for output in outputs:
        name = output
        while name.startswith("der(") and name.endswith(")"):
            name = name[4:-1]
        found.append(name)
        if name not in flat.by_name:
            close = get_close_matches(name, list(flat.by_name), n=3)
            hint = f"did you mean {' or '.join(close)}?" if close else "name a variable of the flat model"
            message = f"the model {flat.name} has no variable `{name}`"
            problems.append(Diagnostic("outputs.unknown-name", message, names=(name,), hint=hint))
    if problems:
        raise UsageProblem(problems)
    return found


def _when_roots(when: When) -> Iterator[Expr]:
    """Everything that a when-clause computes or writes."""
    for branch in when.branches:
        yield from branch.conditions
        for equation in branch.equations:
            yield equation.left
            yield equation.right
        for reinit in branch.reinits:
            yield reinit.state
            yield reinit.value
        for assertion in branch.assertions:
            yield assertion.condition


@dataclass(frozen=True)
class Kept:
    """The names of unknowns that stay; everything else that has a name is known anyway."""

    names: frozenset[str]
    unknowns: frozenset[str]

    def has(self, name: str) -> bool:
        """Whether what has this name is there."""
        return name in self.names or name not in self.unknowns


class _Closure:
    """Who needs whom: `_needs[name]` are the groups of names that come with a name."""

    def __init__(self, flat: FlatModel) -> None:
        self._flat = flat
        self._unknowns = frozenset(v.name for v in determined(flat))
        free = (*free_parameters(flat), *dependent_parameters(flat, order_parameters(flat)))
        self._determined = self._unknowns | {v.name for v in free}
        self._groups: list[tuple[str, ...]] = []
        self._needs: dict[str, list[int]] = {}
        self._own: set[str] = set()
        """Variables whose equation holds their derivative."""
        self._equations()
        self._whens()
        for variable in free:
            binding = () if variable.binding is None else (variable.binding,)
            self._group(symbols(binding), (variable.name,))
        for equation in (*flat.equations, *flat.initial_equations):
            held = symbols((equation.left, equation.right))
            self._group(held, [v.name for v in free if v.name in held] if free else ())
        for equation in flat.initial_equations:
            held = symbols((equation.left, equation.right))
            self._group(held, held)

    def of(self, wanted: Iterable[str]) -> Kept:
        """What `wanted` needs, and the start values and clauses that reach into it."""
        names = [name for name in wanted if name in self._determined]
        names += [
            name
            for when in self._flat.whens
            if any(branch.terminations for branch in when.branches)
            for name in symbols(_when_roots(when))
        ]
        kept: set[str] = set()
        while names:
            self._add(names, kept)
            names = self._fixed_from_outside(kept)
        return Kept(frozenset(kept), self._unknowns)

    def _group(self, names: Iterable[str], of: Iterable[str]) -> None:
        held = tuple(name for name in dict.fromkeys(names) if name in self._determined)
        number = len(self._groups)
        self._groups.append(held)
        for name in of:
            if name in self._determined:
                self._needs.setdefault(name, []).append(number)

    def _equations(self) -> None:
        """Match every equation with the variable it determines, derivatives' own ones first."""
        flat = self._flat
        rows = [(e, e.left, e.right) for e in flat.equations]
        rows += [(e, e.left, e.left) for when in flat.whens for e in determining_equations(when)]
        system = structure(rows, determined(flat))
        index = {v.name: Var(i) for i, v in enumerate(system.unknowns)}
        slopes = [
            [index[name] for name in dict.fromkeys(_differentiated(e)) if index.get(name) in row]
            for e, row in zip(flat.equations, system.incidence, strict=False)
        ]
        first = Matcher(slopes, len(index))
        first.augment([Eq(i) for i, row in enumerate(slopes) if row])
        full = Matcher(system.incidence, len(index))
        for eq, var in enumerate(first.var_of_eq):
            if var is not None:
                full.pair(Eq(eq), var)
        full.augment([Eq(eq) for eq, var in enumerate(full.var_of_eq) if var is None])
        for eq, equation in enumerate(flat.equations):
            var = full.var_of_eq[eq]
            assert var is not None  # check_balance has found a complete matching
            name = system.unknowns[var].name
            self._group(symbols((equation.left, equation.right)), (name,))
            if var in slopes[eq]:
                self._own.add(name)

    def _whens(self) -> None:
        for when in self._flat.whens:
            written = [leaf.name for leaf in when.assigned]
            written += [base_name(r.state) for branch in when.branches for r in branch.reinits]
            self._group(symbols(_when_roots(when)), dict.fromkeys(written))

    def _add(self, names: Iterable[str], kept: set[str]) -> None:
        pending = list(names)
        while pending:
            name = pending.pop()
            if name in kept or name not in self._determined:
                continue
            kept.add(name)
            for number in self._needs.get(name, ()):
                pending += self._groups[number]

    def _fixed_from_outside(self, kept: set[str]) -> list[str]:
        """Constrained variables with a fixed start that depend on something kept."""
        candidates = [
            v.name
            for v in self._flat.variables
            if v.fixed
            and v.variability is Variability.CONTINUOUS
            and v.name in self._unknowns
            and v.name not in self._own
            and v.name not in kept
        ]
        if not candidates:
            return []
        users: dict[str, list[str]] = {}
        for name, numbers in self._needs.items():
            for number in numbers:
                for needed in self._groups[number]:
                    users.setdefault(needed, []).append(name)
        reaching: set[str] = set()
        pending = sorted(kept)
        while pending:
            for name in users.get(pending.pop(), ()):
                if name not in reaching:
                    reaching.add(name)
                    pending.append(name)
        return [name for name in candidates if name in reaching]


def _differentiated(equation: Equation) -> Iterator[str]:
    for leaf in all_leaves([equation.left, equation.right]):
        if leaf.op == "der":
            yield from symbols([leaf])
