"""Small causal systems built by hand, so that code and runs are tested without the passes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from acausal.errors import Source, Span
from acausal.lang.flat import REAL, Assertion, Equation, Experiment, FlatModel, Variability, Variable
from acausal.symbolic.causal import (
    Alias,
    Assignment,
    Block,
    BlockKind,
    CausalEquation,
    CausalSystem,
    InitialProblem,
    InitialValue,
    Residual,
    ZeroCrossing,
)
from acausal.symbolic.expressions.expr import Expr, const, der, sub, sym

SOURCE = Source("hand.mo", "model Hand\n  // equations are written in Python\nend Hand;\n")
SPAN = Span(SOURCE, 13, 20)

Pair = tuple[Expr, Expr]


def equation(left: Expr, right: Expr) -> CausalEquation:
    return CausalEquation(left, right, Equation(left, right, SPAN))


def explicit(unknown: Expr, value: Expr) -> Block:
    return Block(BlockKind.EXPLICIT, (Assignment(unknown, value, equation(unknown, value)),))


def torn(
    kind: BlockKind, tearing: Sequence[str], residuals: Sequence[Pair], assignments: Sequence[Pair] = ()
) -> Block:
    return Block(
        kind,
        tuple(Assignment(u, v, equation(u, v)) for u, v in assignments),
        tuple(sym(name) for name in tearing),
        tuple(Residual(sub(left, right), equation(left, right)) for left, right in residuals),
    )


def hand_system(
    states: Mapping[str, float],
    blocks: Sequence[Block],
    *,
    parameters: Mapping[str, float] | None = None,
    relations: Sequence[Expr] = (),
    aliases: Sequence[tuple[str, Expr]] = (),
    assertions: Sequence[Assertion] = (),
    nominal: Mapping[str, float] | None = None,
    units: Mapping[str, str] | None = None,
    guesses: Mapping[str, float] | None = None,
    initial: Sequence[Block] | None = None,
    checks: Sequence[Residual] = (),
    experiment: Experiment | None = None,
) -> CausalSystem:
    """A system whose states start at the given values; `blocks` follow in the initial problem too."""
    nominals, declared = nominal or {}, units or {}
    unknowns = [u.name for block in blocks for u in block.unknowns if u.op == "sym"]
    names = [*states, *unknowns, *(name for name, _ in aliases)]
    variables = [
        Variable(name, REAL, Variability.PARAMETER, SPAN, binding=const(value), top_level=True)
        for name, value in (parameters or {}).items()
    ]
    variables += [
        Variable(
            name,
            REAL,
            Variability.CONTINUOUS,
            SPAN,
            start=const(states[name]) if name in states else None,
            nominal=const(nominals[name]) if name in nominals else None,
            unit=declared.get(name, ""),
            top_level="." not in name,
        )
        for name in names
    ]
    equations = [item.equation for block in blocks for item in (*block.assignments, *block.residuals)]
    flat = FlatModel(
        "Hand",
        "",
        tuple(variables),
        tuple(e.flat for e in equations),
        (),
        tuple(assertions),
        experiment or Experiment(),
        SPAN,
    )
    starts = [explicit(sym(name), const(value)) for name, value in states.items()]
    values = [InitialValue(name, const(value), "fixed") for name, value in states.items()]
    values += [InitialValue(name, const(value), "guess") for name, value in (guesses or {}).items()]
    return CausalSystem(
        flat=flat,
        parameters=tuple(parameters or {}),
        aliases=tuple(Alias(name, value, Equation(sym(name), value, SPAN)) for name, value in aliases),
        equations=tuple(equations),
        states=tuple(states),
        dummy_derivatives=(),
        index=0,
        blocks=tuple(blocks),
        zero_crossings=tuple(ZeroCrossing(r, equations[0] if equations else None, SPAN) for r in relations),
        assertions=tuple(assertions),
        initial=InitialProblem(
            tuple(initial) if initial is not None else (*starts, *blocks), tuple(values), tuple(checks)
        ),
    )


def rate(name: str, value: Expr) -> Block:
    return explicit(der(sym(name)), value)
