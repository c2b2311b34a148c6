"""The whole compiler on one screen: text -> AST -> instance tree -> FlatModel -> CausalSystem -> code.

This is the only driver. It times each stage, proves the flat model with `verify`, can stop after any stage
and print it. Start reading here; each line leads to the module that does the work.
"""

from __future__ import annotations

import gc
import re
import sys
from collections.abc import Callable, Generator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from time import perf_counter
from typing import TYPE_CHECKING, Literal, TypeVar

from acausal.errors import (
    Diagnostic,
    LookupProblem,
    Source,
    Span,
    TypeProblem,
    UnitProblem,
    UsageProblem,
    fail,
)
from acausal.lang import ast
from acausal.lang.access import is_partial
from acausal.lang.base_modelica import print_flat
from acausal.lang.base_reading import decoded_flat, is_base_modelica
from acausal.lang.flat import FlatModel
from acausal.lang.flatten import flatten
from acausal.lang.instance import Instance, print_instance
from acausal.lang.library import ClassNode, Library, name_parts
from acausal.lang.local_balance import check_local_balance
from acausal.lang.modifiers import Context, modifier_of_arguments
from acausal.lang.parser import parse_expression
from acausal.lang.printer import print_class
from acausal.lang.reading_time import seconds_reading
from acausal.lang.restrictions_instances import check_connectors, check_instances
from acausal.lang.scope import Root
from acausal.lang.translate import Translator
from acausal.lang.unit_check import check_units
from acausal.lang.verify import verify
from acausal.symbolic.expressions.text import plain_name, quoted_name
from acausal.symbolic.parameter_cycles import without_cycles
from acausal.symbolic.user_lines import at_users_lines

if TYPE_CHECKING:
    from acausal.codegen.functions import Code
    from acausal.symbolic.causal import CausalSystem

Stage = Literal["ast", "instance", "flat", "causal", "code"]
_T = TypeVar("_T")
STAGES: tuple[Stage, ...] = ("ast", "instance", "flat", "causal", "code")
_INDEXED = re.compile(r"('.*'|\w+)(?:\[(\d+(?:,\d+)*)\])?")
RECURSION_LIMIT = 20_000
"""Python frames that translating the deepest expression the parser admits may take."""


@dataclass(frozen=True)
class Compilation:
    """What one run of the pipeline produced; stages after `stop_after` are None."""

    node: ClassNode
    instance: Instance | None = None
    flat: FlatModel | None = None
    causal: CausalSystem | None = None
    code: Code | None = None
    warnings: tuple[Diagnostic, ...] = ()
    seconds: Mapping[str, float] = field(default_factory=dict[str, float])


def compile_model(
    library: Library,
    name: str,
    parameters: Mapping[str, str] | None = None,
    stop_after: Stage = "code",
    root: Root | None = None,
    outputs: Sequence[str] | None = None,
) -> Compilation:
    """Compile the class `name` with `parameters` (Modelica expressions by dotted name) applied to it.

    With `outputs`, what these do not need is left out after the flat model (`symbolic.outputs`). `root` keeps
    the scopes of the library's classes from one compilation to the next. Raises the `AcausalError` of the
    stage that finds something wrong.
    """
    clock = _Clock()
    with _compiling(name):
        node = clock.run("parse", lambda: library.find(name))
        if stop_after == "ast":
            return Compilation(node, seconds=clock.seconds)
        translator = Translator(root or Root(library))
        instance = clock.run("flatten", lambda: instantiate(translator, node, parameters or {}))
        if stop_after == "instance":
            return Compilation(node, instance, seconds=clock.seconds)
        flat, warnings = clock.run("flatten", lambda: flatten_and_check(translator, instance))
        warnings = (*library.warnings, *warnings)
        if stop_after == "flat":
            return Compilation(node, instance, flat, warnings=warnings, seconds=clock.seconds)
        from acausal.symbolic.causalise import causalise  # late: a check does not need it

        with at_users_lines(flat):
            causal = clock.run("causalise", lambda: causalise(flat, outputs))
        warnings = (*warnings, *[w for w in causal.flat.warnings if w not in flat.warnings])
        if stop_after == "causal":
            return Compilation(node, instance, flat, causal, warnings=warnings, seconds=clock.seconds)
        from acausal.codegen.functions import generate  # late: without code there is no need for CasADi

        code = clock.run("codegen", lambda: generate(causal))
        return Compilation(node, instance, flat, causal, code, warnings, clock.seconds)


def instantiate(translator: Translator, node: ClassNode, parameters: Mapping[str, str]) -> Instance:
    """The complete instance tree of the top-level class, with the parameters as its modification."""
    scope = translator.root.find(node.path)
    if scope.kind not in ("model", "block", "class"):
        raise fail(
            LookupProblem,
            "model.not-a-model",
            f"`{node.path}` is a {scope.kind}; only models and blocks can be compiled",
            node.definition.span,
            names=[node.path],
            hint="name a model inside it" if scope.kind == "package" else "put it into a model",
        )
    if is_partial(scope):
        raise fail(
            LookupProblem,
            "model.partial",
            f"`{node.path}` is partial and cannot be compiled",
            node.definition.span,
            names=[node.path],
            hint="compile a class that extends it",
        )
    name_of = quoted_name if is_base_modelica(node.definition.span.source) else plain_name
    given = [parameter_modification(name_of(name), text) for name, text in parameters.items()]
    modifier = modifier_of_arguments(given, Context(scope, None))
    root = translator.instances.complete(translator.instances.model(scope, modifier))
    check_instances(root, translator)
    return root


def flatten_and_check(translator: Translator, instance: Instance) -> tuple[FlatModel, tuple[Diagnostic, ...]]:
    """The proven flat model, and the warnings about it. A provable unit clash is an error."""
    flat = flatten(translator, instance)
    if is_base_modelica(instance.scope.span.source):
        flat = decoded_flat(flat, instance.scope.definition)
    flat = without_cycles(flat)
    verify(flat)
    check_connectors(instance)
    if flat.equation_count == len(flat.unknowns) and not translator.instances.overdetermined:
        check_local_balance(flat, instance)  # of an unbalanced model the global count has more to say
    units = check_units(flat)
    errors = [d for d in units if d.severity == "error"]
    if errors:
        raise UnitProblem(errors)
    return flat, (*flat.warnings, *units)


def parameter_modification(name: str, text: str) -> ast.ElementModification:
    """`-p name=text` as a modification of the top-level class."""
    source = Source(f"-p {name}", text)
    span = Span(source, 0, len(text))
    parts = _with_indices(name_parts(name))
    if not parts:
        raise fail(
            UsageProblem,
            "usage.parameter-name",
            f"`{name}` is not the name of a parameter",
            names=[name],
            hint="a dotted path of names; an array is given whole, NAME={1, 2}, or by element, NAME[2]=1",
        )
    value = ast.Modification((), parse_expression(source), span)
    return ast.ElementModification(parts, value, False, False, ast.Comment(None, None), span)


def _with_indices(names: list[str]) -> tuple[str, ...]:
    """The names, each index as one more, `[2]`; nothing if one of them is no name."""
    parts: list[str] = []
    for name in names:
        found = _INDEXED.fullmatch(name)
        if found is None or not (found[1].startswith("'") or found[1].isidentifier()):
            return ()
        parts.append(found[1])
        parts += [f"[{int(index)}]" for index in (found[2] or "").split(",") if index]
    return tuple(parts)


def print_stage(compilation: Compilation, stage: Stage) -> str:
    """The text of one stage. Raises `UsageProblem` when the compilation stopped before it."""
    if stage == "ast":
        return print_class(compilation.node.definition)
    if stage == "instance" and compilation.instance is not None:
        return print_instance(compilation.instance)
    if stage == "flat" and compilation.flat is not None:
        return print_flat(compilation.flat)
    if stage == "causal" and compilation.causal is not None:
        from acausal.symbolic.causal_text import print_causal

        return print_causal(compilation.causal)
    if stage == "code" and compilation.code is not None:
        return compilation.code.describe()
    raise fail(UsageProblem, "usage.stage", f"the compilation stopped before the stage `{stage}`")


class _Clock:
    """Seconds per step, in the JSON contract's words. Reading files is `parse`, wherever it happens."""

    def __init__(self) -> None:
        self.seconds: dict[str, float] = {
            "parse": 0.0,
            "flatten": 0.0,
            "causalise": 0.0,
            "codegen": 0.0,
            "total": 0.0,
        }

    def run(self, step: str, work: Callable[[], _T]) -> _T:
        start, reading = perf_counter(), seconds_reading()
        try:
            return work()
        finally:
            spent, read = perf_counter() - start, seconds_reading() - reading
            self.seconds[step] += spent - read
            self.seconds["parse"] += read
            self.seconds["total"] += spent


@contextmanager
def _compiling(name: str) -> Generator[None, None, None]:
    """Room for nested expressions, and no garbage collection: a compilation makes lasting nodes.

    Raises `TypeProblem` `model.too-deep` where there is not room enough.
    """
    limit, collecting = sys.getrecursionlimit(), gc.isenabled()
    sys.setrecursionlimit(max(limit, RECURSION_LIMIT))
    gc.disable()
    try:
        yield
    except RecursionError:
        message = f"`{name}` has values, classes or calls that lead to each other too deep"
        hint = f"shorten its longest chain of parameters: {RECURSION_LIMIT} calls of Python do not follow it"
        raise fail(TypeProblem, "model.too-deep", message, names=[name], hint=hint) from None
    finally:
        sys.setrecursionlimit(limit)
        if collecting:
            gc.enable()
