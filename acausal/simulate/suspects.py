"""Why equations that could not be solved may be singular: values that are zero, connectors that are loose."""

from __future__ import annotations

from collections.abc import Generator, Iterable, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace

from acausal.codegen.functions import Code
from acausal.errors import AcausalError, Diagnostic
from acausal.lang.flat import Origin, Variable
from acausal.simulate.matrices import Vector
from acausal.simulate.messages import block_equations, leaf_name, number
from acausal.symbolic.causal import CausalEquation, CausalSystem
from acausal.symbolic.describe import place, short_text
from acausal.symbolic.expressions.evaluate import number_of
from acausal.symbolic.expressions.expr import ZERO, Expr, postorder, symbols
from acausal.symbolic.parameters import definition
from acausal.symbolic.user_lines import at_users_lines

_ABOUT = ("simulate.singular-block", "simulate.no-solution", "simulate.not-finite")
_MOST = 3
"""How many suspects are named."""
_SMALL = 30
"""Unknowns of a block in which a loose connector is worth a word: in large ones some are loose on purpose."""


@contextmanager
def naming_suspects(code: Code, p: Vector) -> Generator[None, None, None]:
    """Errors of equations inside it also name what in the model may be the reason, where the user gives it.

    `p` are the values of the parameters.
    """
    system = code.system
    with at_users_lines(system.flat, system.equations):
        try:
            yield
        except AcausalError as error:
            first, *rest = error.diagnostics
            if first.code not in _ABOUT:
                raise
            values = dict(zip(system.parameters, p.tolist(), strict=True))
            reasons = _reasons(system, values, error.diagnostics)[:_MOST]
            if not reasons:
                raise
            hint = "; ".join([*(reason.hint for reason in reasons), *([first.hint] if first.hint else [])])
            raise type(error)([replace(first, hint=hint), *reasons, *rest]) from error.__cause__


def _reasons(
    system: CausalSystem, values: Mapping[str, float], diagnostics: Sequence[Diagnostic]
) -> list[Diagnostic]:
    """What the user set to zero, then what is loose, then what is zero by a default, then differences."""
    code = diagnostics[0].code
    equations = _equations(system, diagnostics)
    factors = list(dict.fromkeys(factor for e in equations for factor in _zeros(e, values)))
    given = list(_given(system, symbols(factors), values))
    by_user = [_zero(variable, code) for variable in given if variable.value_span is not None]
    by_default = [_zero(variable, code) for variable in given if variable.value_span is None]
    small = len(diagnostics[0].names) <= _SMALL
    loose = _loose(system, equations, code, anywhere=not factors) if small else []
    sums = [] if given else [_vanishing(system, factor, values, code) for factor in factors]
    return [*by_user, *loose, *by_default, *sums]


def _zero(variable: Variable, code: str) -> Diagnostic:
    """The reason that a parameter is zero."""
    where = variable.value_span or variable.span
    text = f"`{variable.name}` is zero ({place(where)}), and what it multiplies or divides decides here"
    hint = f"`{variable.name}` is zero: give it another value"
    return Diagnostic(code, text, where, (variable.name,), hint)


def _vanishing(system: CausalSystem, factor: Expr, values: Mapping[str, float], code: str) -> Diagnostic:
    """The reason that an expression is zero though none of its parameters is."""
    names = symbols([factor])
    first = system.flat.by_name[names[0]]
    shown = ", ".join(f"{name} = {number(values[name])}" for name in names)
    what = f"`{short_text(factor)}` is zero"
    text = f"{what} with {shown}, and what it multiplies or divides decides here"
    hint = f"{what}: give its parameters other values"
    return Diagnostic(code, text, first.value_span or first.span, names, hint)


def _loose(
    system: CausalSystem, equations: Iterable[CausalEquation], code: str, *, anywhere: bool
) -> list[Diagnostic]:
    """Connectors without connection whose flow, which is zero, makes something in the equations zero.

    `anywhere`: if there is none, those of the components that the equations stand in.
    """
    flat = system.flat
    zero_flows = {e.left.name: e for e in flat.equations if e.origin is Origin.UNCONNECTED}
    zeros = {alias.name: alias.equation for alias in system.aliases if alias.value is ZERO}
    seen = dict.fromkeys(name for e in equations for name in symbols([e.flat.left, e.flat.right]))
    stack = list(seen)
    while stack:
        eliminated = zeros.get(stack.pop())
        names = () if eliminated is None else symbols([eliminated.left, eliminated.right])
        new = [name for name in names if name not in seen]
        seen.update(dict.fromkeys(new))
        stack += new
    loose = [name for name in seen if name in zero_flows]
    if not loose and anywhere:
        owners = {e.flat.component for e in equations} - {""}
        loose = [name for name in zero_flows if flat.places.owner(name) in owners]
    found: list[Diagnostic] = []
    for name in loose:
        end = name.rpartition(".")[0]
        where = flat.places.components.get(flat.places.owner(name), zero_flows[name].span)
        text = f"`{end}` is not connected ({place(where)}), so that `{name}` is zero"
        hint = f"connect `{end}`, which is connected to nothing"
        found.append(Diagnostic(code, text, where, (name,), hint))
    return found


def _equations(system: CausalSystem, diagnostics: Iterable[Diagnostic]) -> list[CausalEquation]:
    """Those of the block that the first diagnostic is about, and those that the others show."""
    unknowns = frozenset(next(iter(diagnostics)).names)
    blocks = [
        block
        for block in (*system.initial.blocks, *system.blocks)
        if unknowns.issuperset(map(leaf_name, block.unknowns))
    ]
    found = [equation for block in blocks for equation in block_equations(block)]
    named = {name.removeprefix("der(").rstrip(")") for d in diagnostics for name in d.names}
    spans = {(d.span.file, d.span.start) for d in diagnostics if d.span is not None}
    return found + [
        equation
        for equation in system.equations
        if (equation.flat.span.file, equation.flat.span.start) in spans
        and not named.isdisjoint(symbols([equation.left, equation.right]))
    ]


def _zeros(equation: CausalEquation, values: Mapping[str, float]) -> Generator[Expr, None, None]:
    """Factors of something unknown, and what something is divided by, that parameters make zero."""
    known: dict[Expr, bool] = {}
    for node in postorder([equation.left, equation.right]):
        known[node] = node.op == "const" or (
            node.name in values if node.op == "sym" else bool(node.args) and all(known[a] for a in node.args)
        )
        if node.op == "mul" and not known[node]:
            factors = [arg for arg in node.args if known[arg]]
        elif node.op == "div":
            factors = [arg for arg in node.args if known[arg]] if not known[node] else [node.args[1]]
        else:
            continue
        for factor in factors:
            if known[factor] and number_of(factor, values.get) == 0:
                yield factor


def _given(system: CausalSystem, names: Iterable[str], values: Mapping[str, float]) -> Iterable[Variable]:
    """The parameters that are zero, those whose values follow from other zeros replaced by these."""
    by_name = system.flat.by_name
    found: dict[str, Variable] = {}
    stack = [name for name in names if values.get(name) == 0][::-1]
    seen = set(stack)
    while stack:
        variable = by_name[stack.pop()]
        value = definition(variable)
        deeper = [] if value is None else [n for n in symbols([value]) if values.get(n) == 0]
        if deeper:
            stack += [name for name in deeper if name not in seen]
            seen.update(deeper)
        else:
            found[variable.name] = variable
    return found.values()
