"""Algorithm sections of models as equations: one for each variable they assign (Modelica 3.6, 11.1.2).

A section is run symbolically, like a function. A variable begins with its `start` value, or its left limit if
it is discrete; what it has in the end is the right side of its equation.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from acausal.errors import Span
from acausal.lang import ast
from acausal.lang.algorithm_targets import is_discrete, targets_in, whole_variables
from acausal.lang.arithmetic import as_scalar, type_error
from acausal.lang.flat import REAL, Equation, Origin, Termination, Variability
from acausal.lang.function_frame import Frame
from acausal.lang.instance import Instance, Leaf
from acausal.lang.modifiers import Context
from acausal.lang.scope import Scope
from acausal.lang.statements import run_algorithm
from acausal.lang.translation import Env, Translation
from acausal.lang.values import zero_of
from acausal.symbolic.expressions import expr as ex
from acausal.symbolic.expressions.expr import Expr


@dataclass(frozen=True, slots=True)
class SectionResult:
    """What an algorithm section comes to; `discrete`: the Real variables its when-statements assign."""

    equations: tuple[Equation, ...]
    discrete: tuple[str, ...]
    terminations: tuple[tuple[Expr, Termination], ...]


@dataclass(frozen=True, slots=True)
class _Output:
    leaf: Leaf
    span: Span
    discrete: bool


def translate_section(
    translation: Translation, section: ast.AlgorithmSection, scope: Scope, instance: Instance
) -> SectionResult:
    """Run one section of a component. Raises `TypeProblem` and `UnsupportedProblem`."""
    env = Env(Context(scope, instance))
    outputs = _outputs(translation, section.statements, env)
    symbols = [ex.sym(output.leaf.path) for output in outputs]
    start = [_first_value(translation, output) for output in outputs]
    frame = Frame(translation, scope, {}, set(), 0, instance, dict(zip(symbols, start, strict=True)))
    frame.initial = frame.at_event = section.initial
    run_algorithm(frame, [section])
    equations = [
        Equation(symbol, frame.current[symbol], output.span, instance.path, Origin.ALGORITHM)
        for symbol, output in zip(symbols, outputs, strict=True)
    ]
    discrete = [o.leaf.path for o in outputs if o.discrete and o.leaf.type == REAL and not section.initial]
    return SectionResult(tuple(equations), tuple(discrete), tuple(frame.terminations))


def _outputs(translation: Translation, statements: Sequence[ast.Statement], env: Env) -> list[_Output]:
    """The variables that the section assigns, in order of their first assignment, where that is."""
    found: dict[str, _Output] = {}
    for target in targets_in(statements):
        for leaf in whole_variables(translation, target, env):
            old = found.get(leaf.path)
            if old is None:
                found[leaf.path] = _Output(leaf, target.reference.span, target.in_when)
            elif target.in_when and not old.discrete:
                found[leaf.path] = _Output(leaf, old.span, discrete=True)
    return list(found.values())


def _first_value(translation: Translation, output: _Output) -> Expr:
    leaf = output.leaf
    if leaf.prefixes.variability > Variability.PARAMETER and (output.discrete or is_discrete(leaf)):
        return ex.pre(ex.sym(leaf.path))
    start = leaf.attributes.get("start")
    if start is None:
        return zero_of(leaf.type)
    value = as_scalar(translation.binding_value(start), start.span)
    if not value.type.is_numeric and value.type != leaf.type:
        message = f"the attribute `start` of `{leaf.path}` is {value.type}"
        raise type_error("type.mismatch", message, start.span, "", (leaf.path,))
    return value.item
