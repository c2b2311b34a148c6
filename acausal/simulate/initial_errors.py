"""What can be wrong at the start, said with the conditions that the user can change."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from acausal.codegen.functions import Code
from acausal.errors import Diagnostic, InitializationProblem
from acausal.simulate.call import call
from acausal.simulate.matrices import Vector
from acausal.simulate.messages import block_equations, leaf_name, number, some
from acausal.symbolic.causal import InitialCondition, InitialConflict, Residual
from acausal.symbolic.describe import condition_text, equation_with_place, listed, quoted
from acausal.symbolic.expressions.expr import TIME, symbols, unknown_leaves

CHECK_TOLERANCE = 1e-6
"""Largest residual of a redundant initial equation, relative to the size of its terms."""


def check_redundant(code: Code, values: Vector) -> None:
    """Redundant conditions must hold at the result; else `initialize.inconsistent` names all that compete."""
    initial = code.system.initial
    if not initial.checks:
        return
    known = values[[code.initial.slots[leaf] for leaf in code.checks.reads]]
    residuals, sizes = (column.ravel() for column in call(code.checks.run, known))
    unexplained = [None] * (len(initial.checks) - len(initial.conflicts))
    conflicts: Sequence[InitialConflict | None] = [*initial.conflicts, *unexplained]
    problems: list[Diagnostic] = []
    for check, conflict, residual, size in zip(initial.checks, conflicts, residuals, sizes, strict=True):
        if abs(residual) > CHECK_TOLERANCE * max(size, 1e-300):
            problems += _inconsistent(code, values, check, conflict, float(residual))
    if problems:
        raise InitializationProblem(problems)


def _inconsistent(
    code: Code, values: Vector, check: Residual, conflict: InitialConflict | None, off: float
) -> Iterator[Diagnostic]:
    """One diagnostic for the condition that does not hold, one for each that it competes with."""
    slots, flat = code.initial.slots, check.equation.flat
    names = symbols([check.value])
    held = [leaf for leaf in unknown_leaves(check.value) if leaf in slots and leaf != TIME]
    found = some([f"{leaf_name(leaf)} = {number(float(values[slots[leaf]]))}" for leaf in held])
    condition = conflict.condition if conflict is not None else InitialCondition(check.equation)
    others = conflict.others if conflict is not None else ()
    texts = listed([condition_text(other) for other in others])
    why = "it is one condition too many"
    if conflict is not None:
        by = listed([equation_with_place(equation.flat) for equation in conflict.equations], 3)
        why = f"the equations alone determine this: {by}" if by else "the equations alone determine this"
    if others:
        why = f"it is one condition too many beside {texts}"
    message = (
        f"in the initial system the values contradict {condition_text(condition)}, "
        f"which is off by {number(off)}{f', with {found}' if found else ''}: {why}"
    )
    hint = _way_out([condition, *others])
    yield Diagnostic("initialize.inconsistent", message, flat.span, names, hint)
    for other in others:
        text = f"{condition_text(other)} belongs to the conditions in conflict"
        held = symbols([other.equation.left, other.equation.right])
        yield Diagnostic("initialize.inconsistent", text, other.equation.flat.span, held)


def _way_out(conditions: Sequence[InitialCondition]) -> str:
    """What may be given up: one of the conditions."""
    fixed = [f"`{c.start}`" for c in conditions if c.start]
    written = [c for c in conditions if not c.start]
    ways: list[str] = []
    if fixed:
        which = f"one of {listed(fixed)}" if len(fixed) > 1 else fixed[0]
        ways.append(f"remove `fixed = true` from {which}")
    if written:
        ways.append(
            "remove one of the initial equations" if len(written) > 1 else "remove the initial equation"
        )
    return ", ".join([*ways, "or make the values agree"])


def with_starts(
    code: Code, error: InitializationProblem, starts: Mapping[str, float]
) -> InitializationProblem:
    """The error of a block of the initial system, with the start values that its equations hold."""
    first, *rest = error.diagnostics
    reasons = {value.name: value.reason for value in code.system.initial.values}
    named = frozenset(first.names)
    held: list[str] = []
    for block in code.system.initial.blocks:
        if block.tearing and named.issuperset(map(leaf_name, block.unknowns)):
            sides = [side for e in block_equations(block) for side in (e.left, e.right)]
            names = [leaf.name for side in sides for leaf in unknown_leaves(side) if leaf.op == "sym"]
            held += [n for n in dict.fromkeys(names) if reasons.get(n) in _USES and n not in held]
    if not held:
        return error
    texts = [f"{name} = {number(starts[name])} ({_USES[reasons[name]]})" for name in held]
    hint = f"{first.hint}; the block uses the start values {listed(texts)}".removeprefix("; ")
    fixed = [name for name in held if reasons[name] == "fixed"]
    if first.code.endswith("singular-block"):
        pass
    elif fixed:
        hint += f": try to remove `fixed = true` from {quoted(fixed, 'or')}"
    else:
        hint += ": others may help"
    return InitializationProblem([replace(first, hint=hint), *rest])


_USES = {"fixed": "fixed", "assumed": "not fixed, but assumed"}
