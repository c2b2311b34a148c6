"""What cannot be exported as C, refused with the line of the model that holds it."""

from __future__ import annotations

from collections.abc import Iterator

from acausal.codegen.functions import Code
from acausal.errors import AcausalError, Diagnostic, Span, UnsupportedProblem
from acausal.simulate.messages import leaf_name, some
from acausal.symbolic.causal import Block, CausalSystem
from acausal.symbolic.expressions.expr import Expr, postorder
from acausal.symbolic.expressions.kernel import Kernel, Part
from acausal.symbolic.expressions.kernels.formula import Formula
from acausal.symbolic.expressions.kernels.patches import Patches
from acausal.symbolic.expressions.kernels.piecewise import Piecewise

LARGEST = 300
"""Unknowns of a torn block, whose matrix is kept as a whole."""


def check_c(code: Code) -> None:
    """Raises `UnsupportedProblem` for every construct that has no C."""
    check_kernels(code)
    problems = [*_states(code.system), *_large(code)]
    if problems:
        raise UnsupportedProblem(problems)


def check_kernels(code: Code) -> None:
    """Raises `UnsupportedProblem` for functions that are evaluated in Python."""
    problems = list(_kernels(code.system))
    if problems:
        raise UnsupportedProblem(problems)


def _sides(system: CausalSystem) -> Iterator[tuple[Span, tuple[Expr, ...]]]:
    """Every expression of the system with its place."""
    for equation in system.equations:
        yield equation.flat.span, (equation.left, equation.right)
    for block in (*system.blocks, *system.initial.blocks):
        yield from _of_block(block)
    for assignment in (*system.discrete.assignments, *system.discrete.initial):
        yield assignment.equation.flat.span, (assignment.value,)
    for reset in system.discrete.resets:
        yield reset.span, (reset.condition, reset.value)
    for check in system.discrete.checks:
        yield check.assertion.span, (check.condition, check.assertion.condition)
    for stop in system.discrete.stops:
        yield stop.termination.span, (stop.condition,)
    for assertion in system.assertions:
        yield assertion.span, (assertion.condition,)
    for variable in system.flat.variables:
        values = (variable.binding, variable.start, variable.nominal)
        yield variable.span, tuple(value for value in values if value is not None)


def _of_block(block: Block) -> Iterator[tuple[Span, tuple[Expr, ...]]]:
    for assignment in block.assignments:
        yield assignment.equation.flat.span, (assignment.value,)
    for residual in block.residuals:
        yield residual.equation.flat.span, (residual.value,)


def _kernels(system: CausalSystem) -> Iterator[Diagnostic]:
    seen: set[str] = set()
    for span, roots in _sides(system):
        for node in postorder(roots):
            if node.op != "call":
                continue
            if node.kernel.result == "String" or node.kernel.key in seen or _has_code(node.kernel):
                continue
            seen.add(node.kernel.key)
            message = f"`{node.kernel.name}` is evaluated in Python and cannot be exported"
            hint = "replace the function by equations, or run the model inside Python"
            yield Diagnostic("export.kernel", message, span, (node.kernel.name,), hint)


def _has_code(kernel: Kernel) -> bool:
    """Whether a function that is kept as a unit consists of expressions alone."""
    if isinstance(kernel, Piecewise | Patches):
        return True
    if not isinstance(kernel, Part) or not isinstance(kernel.whole, Formula):
        return False
    return all(_has_code(node.kernel) for node in postorder(kernel.whole.results) if node.op == "call")


def _states(system: CausalSystem) -> Iterator[Diagnostic]:
    if system.dynamic is None:
        return
    monitor = system.dynamic.monitors[0]
    names = (*monitor.solved_for, *monitor.alternatives)
    message = (
        f"the states change during a run: {some(monitor.solved_for)} may become {some(monitor.alternatives)}"
    )
    hint = "write the model in coordinates that are good everywhere, or fix the choice with stateSelect"
    yield Diagnostic("export.dynamic-states", message, monitor.constraints[0].flat.span, names, hint)


def _large(code: Code) -> Iterator[Diagnostic]:
    for block in (*code.dynamic.blocks, *code.initial.blocks):
        if len(block.tearing) > LARGEST:
            names = tuple(map(leaf_name, block.tearing))
            message = (
                f"a block of {len(names)} unknowns after tearing is too large for an export: {some(names)}"
            )
            span = block.residuals[0].equation.flat.span
            yield Diagnostic("export.large-block", message, span, names, f"at most {LARGEST} can be")


def no_c(problem: RuntimeError, code: Code) -> AcausalError:
    """What CasADi cannot write as C for a reason that was not foreseen."""
    first = (str(problem).strip().splitlines() or ["no reason given"])[-1]
    message = f"no C could be generated: {first[:200]}"
    return UnsupportedProblem(Diagnostic("export.no-c", message, code.system.flat.span))
