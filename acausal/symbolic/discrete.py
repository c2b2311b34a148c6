"""Which equations are discrete, what they determine, and in which order they are evaluated at an event.

An equation is discrete if it is not between Reals, comes from a when-clause, or determines a discrete Real
from values that change at events only. It gives one discrete variable as `v = expression`. All others are
continuous: discrete variables are known in them, because they are constant between events.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

from acausal.errors import BalanceProblem, Diagnostic, TypeProblem, fail
from acausal.lang.flat import REAL, Variable
from acausal.symbolic.alias import Simplified
from acausal.symbolic.causal import Assignment, CausalEquation, DiscretePart
from acausal.symbolic.describe import base_name, equation_with_place, listed, quoted, shown
from acausal.symbolic.events import Holder
from acausal.symbolic.expressions.expr import Expr, postorder, sym, symbols
from acausal.symbolic.expressions.node import Wide
from acausal.symbolic.graphs.blt import strong_components
from acausal.symbolic.graphs.matching import Matcher
from acausal.symbolic.graphs.types import Eq, Var
from acausal.symbolic.leaves import is_discrete, is_moving, value_leaves
from acausal.symbolic.parameters import free_parameters
from acausal.symbolic.solving import Profiler, Solvability, solve
from acausal.symbolic.when_clauses import is_momentary


@dataclass(frozen=True)
class Divided:
    """`continuous`: the model without its discrete equations and unknowns; `definitions`: those, solved."""

    continuous: Simplified
    definitions: tuple[Assignment, ...]
    """One for every discrete variable, in the order of their equations."""
    initial: tuple[CausalEquation, ...]
    """The initial equations that determine discrete variables or their values before the start."""

    @property
    def variables(self) -> tuple[Expr, ...]:
        return tuple([definition.unknown for definition in self.definitions])


def divide(model: Simplified, profiler: Profiler) -> Divided:
    """Separate discrete equations from continuous ones. Near-linear.

    Raises BalanceProblem `discrete.undetermined`.
    """
    names = {v.name: v for v in model.unknowns if is_discrete(v)}
    if not names:
        return Divided(model, (), ())
    chosen = _matched(model, names, profiler)
    definitions = [_definition(model.equations[i], sym(name)) for i, name in sorted(chosen.items())]
    free = {v.name for v in free_parameters(model.flat)}
    about = [bool(discrete_sides(e, names)) and not _sets_parameter(e, free) for e in model.initial_equations]
    initial = [e for e, discrete in zip(model.initial_equations, about, strict=True) if discrete]
    kept = [e for e, discrete in zip(model.initial_equations, about, strict=True) if not discrete]
    continuous = replace(
        model,
        unknowns=tuple([v for v in model.unknowns if v.name not in names]),
        equations=tuple([e for i, e in enumerate(model.equations) if i not in chosen]),
        initial_equations=tuple(kept),
    )
    return Divided(continuous, tuple(definitions), tuple(initial))


def _sets_parameter(equation: CausalEquation, free: Collection[str]) -> bool:
    """`v = p` with a parameter that has no value yet is about the parameter."""
    return any(side.op == "sym" and side.name in free for side in (equation.left, equation.right))


def discrete_sides(equation: CausalEquation, names: Mapping[str, object]) -> list[tuple[Expr, Expr]]:
    """(leaf, value) for each side of an initial equation that it may determine as a discrete variable's.

    `x = v` with a continuous x is about x.
    """
    left, right = equation.left, equation.right
    found = [(left, right)] if _is_discrete(left, names) else []
    about_left = left.op in ("sym", "der") and not found
    return found if about_left or not _is_discrete(right, names) else [*found, (right, left)]


def _is_discrete(leaf: Expr, names: Mapping[str, object]) -> bool:
    if leaf.op == "pre":
        leaf = leaf.args[0]
    return leaf.op == "sym" and leaf.name in names


def _matched(model: Simplified, names: Mapping[str, Variable], profiler: Profiler) -> dict[int, str]:
    """Which equation (by position) determines which discrete variable."""
    index = {name: Var(i) for i, name in enumerate(names)}
    order = list(names)
    positions: list[int] = []
    matcher = Matcher([], len(names))
    weak: list[Eq] = []
    for i, equation in enumerate(model.equations):
        found = _candidates(equation, names, profiler)
        if not found:
            continue
        positions.append(i)
        eq = matcher.add_equation([index[name] for name in found])
        if _is_strong(equation, model, profiler):
            matcher.augment([eq])
        else:
            weak.append(eq)
    matcher.augment(weak)
    free = [order[i] for i, eq in enumerate(matcher.eq_of_var) if eq is None]
    if free:
        raise _undetermined(model, free)
    chosen = {positions[eq]: order[i] for i, eq in enumerate(matcher.eq_of_var) if eq is not None}
    by_name = model.flat.by_name
    for i, name in chosen.items():
        sides = (model.equations[i].left, model.equations[i].right)
        if names[name].type != REAL and any(
            is_moving(by_name.get(base_name(s))) for s in steady_leaves(sides)
        ):
            raise _continuous(model, model.equations[i], names[name])
    return chosen


def _continuous(model: Simplified, equation: CausalEquation, variable: Variable) -> TypeProblem:
    """The error for an Integer or the like that only an equation with continuous values determines."""
    moving = [n for n in symbols([equation.left, equation.right]) if is_moving(model.flat.by_name.get(n))]
    return fail(
        TypeProblem,
        "type.discrete",
        f"`{variable.name}` is {variable.type} and changes at events only, but in the running system only "
        f"{equation_with_place(equation.flat)} can determine it, with the continuous {quoted(moving)}",
        equation.flat.span,
        names=[variable.name, *moving],
        hint=f"make `{variable.name}` a Real, or use integer(...), which raises events",
    )


def _candidates(equation: CausalEquation, names: Mapping[str, Variable], profiler: Profiler) -> list[str]:
    """The discrete variables for which an equation can be solved."""
    if not any(
        leaf.op == "sym" and leaf.name in names for leaf in value_leaves((equation.left, equation.right))
    ):
        return []
    solvable = profiler.profile(equation).solvable
    return [
        leaf.name
        for leaf, how in solvable.items()
        if leaf.op == "sym" and leaf.name in names and how <= Solvability.VARYING
    ]


def _is_strong(equation: CausalEquation, model: Simplified, profiler: Profiler) -> bool:
    """Whether the equation cannot determine anything continuous."""
    if not (profiler.is_numeric(equation.left) and profiler.is_numeric(equation.right)):
        return True
    leaves = steady_leaves((equation.left, equation.right))
    by_name = model.flat.by_name
    return not any(
        leaf.op == "der" or (leaf.op == "sym" and is_moving(by_name.get(leaf.name))) for leaf in leaves
    )


def steady_leaves(roots: Iterable[Expr]) -> list[Expr]:
    """The leaves that an equation could be solved for, without what is used at events only."""
    found: list[Expr] = []
    stack = [*roots]
    while stack:
        node = stack.pop()
        if node.op == "if" and is_momentary(node.args[0]):
            stack.append(node.args[2])
        elif node.op in ("if", "add", "neg", "mul", "div", "noEvent", "smooth"):
            stack.extend(node.args[1:] if node.op == "if" else node.args)
        else:
            found.extend(value_leaves([node]))
    return found


def _definition(equation: CausalEquation, unknown: Expr) -> Assignment:
    solved = solve(equation, unknown)
    assert solved is not None, f"{unknown!r} was called solvable"
    return solved


def _undetermined(model: Simplified, free: Sequence[str]) -> BalanceProblem:
    by_name = model.flat.by_name
    found: list[Diagnostic] = []
    for name in free:
        also = f", nor {listed(list(free[1:]))}" if name == free[0] and free[1:] else ""
        names: tuple[str, ...] = (name,)
        itself = next((e for e in model.equations if name in symbols([e.left, e.right])), None)
        if itself is None:
            message = f"no equation gives the discrete variable `{name}` a value at events{also}"
            hint = f"assign it in a when-clause, or write `{name} = ...` with what changes at events only"
            span = by_name[name].span
        else:
            message = (
                f"the discrete variable `{name}` depends on itself at one instant in the running system: "
                f"`{shown(itself)}` cannot be solved for it, and no other equation gives it a value{also}"
            )
            hint = f"use `pre({name})` for its value before the event, or another equation for `{name}`"
            span = itself.flat.span
            also_held = symbols([itself.flat.left, itself.flat.right])
            names = tuple(dict.fromkeys((name, *also_held)))
        found.append(Diagnostic("discrete.undetermined", message, span, names, hint))
    return BalanceProblem(found)


def discrete_part(
    definitions: Sequence[Assignment], holders: Sequence[Holder], everything: Iterable[Expr]
) -> DiscretePart:
    """The discrete part without actions and initial values; `everything` is all that is ever evaluated.

    Definitions are sorted so that each uses earlier ones; those in a loop keep their order.
    """
    held = [Assignment(h.node, h.node, h.equation) for h in holders]
    nodes = list(postorder(everything))
    memory = [node for node in nodes if node.op == "pre"]
    phases = [node for node in nodes if node.op in ("initial", "terminal")]
    return DiscretePart(
        assignments=in_order([*definitions, *held]),
        memory=tuple(memory),
        samples=tuple([node for node in nodes if node.op == "sample"]),
        phases=tuple(phases),
    )


def in_order(assignments: Sequence[Assignment]) -> tuple[Assignment, ...]:
    """Sorted so that each assignment uses earlier ones, except in loops. Near-linear."""
    uses = _Uses({a.unknown: Var(i) for i, a in enumerate(assignments)})
    incidence = [sorted({Var(i), *uses.of(a)}) for i, a in enumerate(assignments)]
    incidence += uses.of_shared()
    matcher = Matcher(incidence, len(incidence))
    for i in range(len(incidence)):
        matcher.pair(Eq(i), Var(i))
    components = strong_components(incidence, matcher.freeze())
    order = [eq for component in components for eq in component.equations]
    return tuple([assignments[eq] for eq in order if eq < len(assignments)])


class _Uses:
    """Which unknowns assignments read. The arguments that calls share count as an unknown of their own."""

    def __init__(self, unknowns: Mapping[Expr, Var]) -> None:
        self._unknowns = unknowns
        self._shared: dict[Wide, Var] = {}

    def of(self, assignment: Assignment) -> list[Var]:
        """The other unknowns that the value reads."""
        value = assignment.value
        return self._below(value.args if value is assignment.unknown else [value])

    def of_shared(self) -> list[list[Var]]:
        """What the shared arguments met so far read, and those met on the way: themselves first."""
        found: list[list[Var]] = []
        waiting = [*self._shared]
        while waiting:
            found += [sorted({self._shared[wide], *self._below(wide.args)}) for wide in waiting]
            waiting = [*self._shared][len(found) :]
        return found

    def _below(self, roots: Iterable[Expr]) -> list[Var]:
        stack = [*roots]
        seen: set[Expr] = set()
        found: list[Var] = []
        while stack:
            node = stack.pop()
            if node in seen:
                continue
            seen.add(node)
            if node in self._unknowns:
                found.append(self._unknowns[node])
            elif node.op == "call" and node.wide is not None:
                new = Var(len(self._unknowns) + len(self._shared))
                found.append(self._shared.setdefault(node.wide, new))
            elif node.op != "pre":
                stack.extend(node.args)
        return found
