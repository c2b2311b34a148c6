"""The initial point: what every start value became, what moves at the start, how well the equations hold."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from math import isfinite

from acausal.codegen.functions import Code
from acausal.errors import Diagnostic, LookupProblem
from acausal.explain.folding import listing
from acausal.explain.words import counted, short, where
from acausal.simulate.messages import number
from acausal.simulate.result import Result
from acausal.simulate.simulate import simulate
from acausal.symbolic.causal import BlockKind, CausalEquation, CausalSystem
from acausal.symbolic.describe import equation_text
from acausal.symbolic.expressions.evaluate import number_of
from acausal.symbolic.expressions.expr import Constant, Expr, const, neg, substitute, unknown_leaves
from acausal.symbolic.expressions.text import to_text

MOST_ROWS = 40
_MOST_MOVING, _MOST_TEXT = 10, 160
_TITLES = {
    "fixed": "Fixed",
    "assumed": "Assumed: not fixed, but needed as equations",
    "nobody": "Assumed though nobody gave them: the default",
    "guess": "Guesses: where iterations started, and what they found",
}


@dataclass(frozen=True, slots=True)
class Started:
    """A start value, what the variable is at the start, and how it was used (see `_TITLES`)."""

    name: str
    start: float
    value: float
    use: str


@dataclass(frozen=True, slots=True)
class Held:
    """An equation that was solved by iteration: the difference of its sides, relative to its terms' sizes."""

    equation: CausalEquation
    residual: float


@dataclass(frozen=True)
class InitialReport:
    """What the solved initial problem looks like."""

    model: str
    time: float
    starts: tuple[Started, ...]
    moving: tuple[tuple[str, float], ...]
    """Derivatives of states that are not zero, those first that change most relative to the value."""
    held: tuple[Held, ...]
    """Worst first."""
    warnings: tuple[Diagnostic, ...]

    def text(self, *, everything: bool = False) -> str:
        """For people; long lists end after `MOST_ROWS` rows unless `everything` is asked for."""
        return "\n".join(_lines(self, None if everything else MOST_ROWS))

    def to_json(self) -> dict[str, object]:
        """The key `initial_point` of `acausal explain --initial --json`."""
        return {
            "time": self.time,
            "starts": [
                {"name": s.name, "start": s.start, "value": s.value, "use": s.use} for s in self.starts
            ],
            "derivatives": dict(self.moving),
            "residuals": [
                {
                    "equation": equation_text(held.equation.flat),
                    "file": held.equation.flat.span.file,
                    "line": held.equation.flat.span.line,
                    "residual": held.residual,
                }
                for held in self.held
            ],
            "warnings": [warning.to_json() for warning in self.warnings],
        }


def initial_report(code: Code) -> InitialReport:
    """Solve the initial problem and look at the result.

    Raises what `simulate` raises, above all `InitializationProblem`.
    """
    start = code.system.flat.experiment.start_time or 0.0
    result = simulate(code, start_time=start, stop_time=start)
    system = code.system
    return InitialReport(
        system.flat.name,
        start,
        tuple(_started(system, result)),
        tuple(_moving(system, result)),
        tuple(sorted(_held(system, result), key=lambda held: -held.residual)),
        result.warnings,
    )


def _value(result: Result, name: str) -> float:
    known = result.parameters.get(name)
    return float(result.values(name)[0]) if known is None else float(known)


def _started(system: CausalSystem, result: Result) -> Iterable[Started]:
    for used in result.starts:
        variable = system.flat.by_name.get(used.name)
        given = variable is not None and (variable.start is not None or variable.binding is not None)
        use = "nobody" if used.reason == "assumed" and not given else used.reason
        yield Started(used.name, used.value, _value(result, used.name), use)


def _moving(system: CausalSystem, result: Result) -> list[tuple[str, float]]:
    slopes = {name: float(result.values(f"der({name})")[0]) for name in system.states}
    found = {name: slope for name, slope in slopes.items() if slope != 0}
    order = sorted(found, key=lambda name: -abs(found[name]) / max(abs(_value(result, name)), 1e-12))
    return [(name, found[name]) for name in order]


def _held(system: CausalSystem, result: Result) -> Iterable[Held]:
    for block in system.initial.blocks:
        if block.kind is BlockKind.NONLINEAR:
            for residual in block.residuals:
                sides = (residual.equation.left, residual.equation.right)
                left, right = ([_number(term, result) for term in _terms(side)] for side in sides)
                numbers = [value for value in (*left, *right) if value is not None and isfinite(value)]
                if len(numbers) == len(left) + len(right):
                    off = abs(sum(numbers[: len(left)]) - sum(numbers[len(left) :]))
                    yield Held(residual.equation, off / max(sum(map(abs, numbers)), 1e-300))


def _terms(side: Expr) -> Iterable[Expr]:
    """What is added up: in `0 = a - b` only these say what is small."""
    stack = [(side, 1)]
    while stack:
        node, sign = stack.pop()
        if node.op in ("add", "neg"):
            stack += [(arg, -sign if node.op == "neg" else sign) for arg in reversed(node.args)]
        else:
            yield node if sign > 0 else neg(node)


def _number(expr: Expr, result: Result) -> float | None:
    """The value at the start; None where Python cannot tell it."""

    def lookup(name: str) -> Constant | None:
        return result.time[0] if name == "time" else _value(result, name)

    try:
        slopes = {x: const(_value(result, to_text(x))) for x in unknown_leaves(expr) if x.op == "der"}
        return number_of(substitute(expr, slopes), lookup)
    except LookupProblem:
        return None


def _lines(report: InitialReport, most: int | None) -> Iterable[str]:
    yield f"Initial point of {report.model} at {number(report.time)} s"
    for use, title in _TITLES.items():
        lines = [_start_line(s) for s in report.starts if s.use == use]
        if lines:
            yield from ("", f"{title}: {counted(len(lines), 'start value')}")
            yield from listing(lines, most)
    yield ""
    yield from _moving_lines(report.moving)
    if report.held:
        worst = report.held[0]
        yield f"{counted(len(report.held), 'equation')} solved by iteration; the largest relative residual is"
        text = short(equation_text(worst.equation.flat), _MOST_TEXT)
        yield f"  {number(worst.residual)} in `{text}` ({where(worst.equation)})"


def _start_line(start: Started) -> str:
    found = "" if start.value == start.start else f"  ->  {number(start.value)}"
    return f"{start.name} = {number(start.start)}{found}"


def _moving_lines(moving: Sequence[tuple[str, float]]) -> Iterable[str]:
    if not moving:
        yield "at rest: no state moves at the start"
        return
    yield f"{counted(len(moving), 'state')} in motion at the start; those that change fastest for their size"
    yield from (f"  der({name}) = {number(slope)}" for name, slope in moving[:_MOST_MOVING])
