"""Algorithm sections of models as equations: one for each variable they assign (Modelica 3.6, 11.1.2).

A section is run symbolically, like a function. A variable begins with its `start` value, or its left limit if
it is discrete; what it has in the end is the right side of its equation.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

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
    settled = {} if section.initial else _settling(translation, section.statements, env, outputs)
    final = _run(frame, section, settled)
    equations = [
        Equation(symbol, final[symbol], output.span, instance.path, Origin.ALGORITHM)
        for symbol, output in zip(symbols, outputs, strict=True)
    ]
    discrete = [o.leaf.path for o in outputs if o.discrete and o.leaf.type == REAL and not section.initial]
    return SectionResult(tuple(equations), tuple(discrete), tuple(frame.terminations))


def _run(
    frame: Frame, section: ast.AlgorithmSection, settled: Mapping[int, Sequence[Expr]]
) -> dict[Expr, Expr]:
    """Run the statements; the values of the variables in the end.

    What a variable has when it is settled is its value: the statements that follow name it.
    """
    final: dict[Expr, Expr] = {}
    begin = 0
    for end, symbols in settled.items():
        run_algorithm(frame, [replace(section, statements=section.statements[begin:end])])
        for symbol in symbols:
            final[symbol] = frame.current[symbol]
            frame.current[symbol] = symbol
        begin = end
    run_algorithm(frame, [replace(section, statements=section.statements[begin:])])
    return {**frame.current, **final}


def _settling(
    translation: Translation, statements: Sequence[ast.Statement], env: Env, outputs: Sequence[_Output]
) -> dict[int, list[Expr]]:
    """After how many statements which of the discrete variables are not assigned any more."""
    if not any(isinstance(statement, ast.WhenStatement) for statement in statements[:-1]):
        return {}
    last: dict[str, int] = {}
    for k, statement in enumerate(statements, start=1):
        for target in targets_in([statement]):
            last.update(dict.fromkeys([leaf.path for leaf in whole_variables(translation, target, env)], k))
    found: dict[int, list[Expr]] = {}
    for output in outputs:
        k = last[output.leaf.path]
        if output.discrete and k < len(statements):
            found.setdefault(k, []).append(ex.sym(output.leaf.path))
    return dict(sorted(found.items()))


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
