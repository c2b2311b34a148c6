"""Reading Base Modelica (MCP-0031): texts with the header `//! base`, such as `print_flat` writes.

Base Modelica is nearly a subset of Modelica, so the parser and the front end read it. What it has beyond
Modelica is taken out first, keeping all positions: decorations (`@17`) and `pure constant`. The names of a
lowered model are quoted identifiers (`'body.phi'`); the flat model gets the names that they stand for.
What this version does not know (`guess`, `prioritize`, clock partitions) is refused by name.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import replace

from acausal.errors import Source, Span, UnsupportedProblem, fail
from acausal.lang import ast
from acausal.lang.flat import (
    Assertion,
    Causality,
    Equation,
    FlatModel,
    Reinit,
    ScalarType,
    Termination,
    Variable,
    When,
    WhenBranch,
)
from acausal.symbolic.expressions import expr as ex
from acausal.symbolic.expressions.expr import EnumValue, Expr, postorder
from acausal.symbolic.expressions.walk import substitute

_HEADER = re.compile(r"//! base \d+\.\d+[r.]\d+[ \t]*(?:\r?\n|$)")
_PIECE = re.compile(
    r"""//[^\n]* | /\*.*?\*/ | "(?:[^"\\]|\\.)*" | '(?:[^'\\]|\\.)*'
    | (?P<decoration>@[ \t\r\n]*[0-9]+) | (?P<pure>\bpure[ \t\r\n]+constant\b)
    | (?P<refused>\b(?:guess|prioritize)(?=[ \t\r\n]*\() | \b(?:sub)?partition\b)""",
    re.VERBOSE | re.DOTALL,
)
_QUOTED = re.compile(r"'((?:[^'\\]|\\.)*)'")
_ESCAPE = re.compile(r"\\(.)", re.DOTALL)


def is_base_modelica(source: Source) -> bool:
    """Whether the text begins with the header of Base Modelica."""
    return _HEADER.match(source.text) is not None


def as_modelica_text(source: Source) -> Source:
    """The text without what only Base Modelica has, every other character at its place.

    Raises `UnsupportedProblem` `unsupported.base-modelica`.
    """

    def plain(found: re.Match[str]) -> str:
        text = found[0]
        if found["refused"] is not None:
            raise fail(
                UnsupportedProblem,
                "unsupported.base-modelica",
                f"`{text}` of Base Modelica is not supported yet",
                Span(source, found.start(), found.end()),
            )
        if found["decoration"] is not None:
            return re.sub(r"[^\r\n]", " ", text)
        if found["pure"] is not None:
            return text.removesuffix("constant") + " " * len("constant")
        return text

    return Source(source.path, _PIECE.sub(plain, source.text))


def model_of(stored: ast.StoredDefinition) -> str:
    """The full name of the model in a file of Base Modelica: the package's last model, of the same name."""
    package = stored.classes[-1][1]
    elements = package.body.elements if isinstance(package, ast.LongClass) else ()
    models = [e for e in elements if isinstance(e, ast.ClassDefinition) and e.kind == "model"]
    return f"{package.name}.{models[-1].name}" if models else package.name


def decoded(name: str) -> str:
    """What an identifier or a reference of Base Modelica stands for: `'a.b'[2]` is `a.b[2]`."""
    return _QUOTED.sub(lambda found: _ESCAPE.sub(r"\1", found[1]), name)


def decoded_flat(flat: FlatModel, definition: ast.ClassDefinition) -> FlatModel:
    """The flat model of a text in Base Modelica, under the names of the model that it was made from."""
    package = flat.name.removesuffix(f".{definition.name}") + "."
    type_name = _type_namer(package)
    rename = _renamer(flat, type_name)
    hidden = frozenset(_protected(definition))
    flat = _with_initial_branches(flat)
    return replace(
        flat,
        name=decoded(definition.name),
        variables=tuple([_variable(v, rename, type_name, v.name in hidden) for v in flat.variables]),
        equations=_equations(flat.equations, rename),
        initial_equations=_equations(flat.initial_equations, rename),
        assertions=_assertions(flat.assertions, rename),
        whens=tuple([_when(when, rename) for when in flat.whens]),
    )


def _with_initial_branches(flat: FlatModel) -> FlatModel:
    """When-clauses with what they do at initialisation, which Base Modelica writes as initial equations.

    `v = pre(v)` goes without saying; of a clause whose variables all have a value there, these equations
    become its branch `initial()`.
    """
    values = {e.left: e for e in flat.initial_equations if e.right is not ex.pre(e.left)}
    implied = {e.left: e for e in flat.initial_equations if e.right is ex.pre(e.left)}
    taken: dict[int, None] = {}
    whens: list[When] = []
    for when in flat.whens:
        left = when.assigned
        silent = not any(c.op == "initial" for branch in when.branches for c in branch.conditions)
        given = [values[v] for v in left if v in values and v not in implied]
        if silent and left and len(given) == len(left):
            start = WhenBranch((ex.initial(),), tuple(given), (), (), (), when.span)
            taken |= {id(e): None for e in given}
            whens.append(replace(when, branches=(start, *when.branches)))
        else:
            taken |= {id(implied[v]): None for v in left if silent and v in implied}
            whens.append(when)
    kept = tuple([e for e in flat.initial_equations if id(e) not in taken])
    return replace(flat, initial_equations=kept, whens=tuple(whens))


_Rename = Callable[[Expr], Expr]


def _type_namer(package: str) -> Callable[[str], str]:
    return lambda name: decoded(name.removeprefix(package))


def _renamer(flat: FlatModel, type_name: Callable[[str], str]) -> _Rename:
    mapping: dict[Expr, Expr] = {}
    for node in postorder(_expressions(flat)):
        value = node.value
        if node.op == "sym" and "'" in node.name:
            mapping[node] = ex.sym(decoded(node.name))
        elif isinstance(value, EnumValue):
            mapping[node] = ex.const(replace(value, type_name=type_name(value.type_name)))
    memo: dict[Expr, Expr] = {}
    return lambda expression: substitute(expression, mapping, memo) if mapping else expression


def _expressions(flat: FlatModel) -> Iterator[Expr]:
    for v in flat.variables:
        yield from (e for e in (v.binding, v.start, v.nominal, v.min, v.max) if e is not None)
    branches = [branch for when in flat.whens for branch in when.branches]
    for equation in (*flat.equations, *flat.initial_equations, *(e for b in branches for e in b.equations)):
        yield equation.left
        yield equation.right
    for assertion in (*flat.assertions, *(a for b in branches for a in b.assertions)):
        yield assertion.condition
        yield assertion.message
    for branch in branches:
        yield from branch.conditions
        yield from (e for reinit in branch.reinits for e in (reinit.state, reinit.value))
        yield from (termination.message for termination in branch.terminations)


def _variable(v: Variable, rename: _Rename, type_name: Callable[[str], str], protected: bool) -> Variable:
    def maybe(expression: Expr | None) -> Expr | None:
        return None if expression is None else rename(expression)

    name = decoded(v.name)
    kind = ScalarType(type_name(v.type.name), v.type.literals) if v.type.is_enumeration else v.type
    return replace(
        v,
        name=name,
        type=kind,
        binding=maybe(v.binding),
        start=maybe(v.start),
        nominal=maybe(v.nominal),
        min=maybe(v.min),
        max=maybe(v.max),
        protected=v.protected or protected,
        top_level=v.causality is not Causality.LOCAL or "." not in name,
    )


def _equations(equations: tuple[Equation, ...], rename: _Rename) -> tuple[Equation, ...]:
    return tuple([replace(e, left=rename(e.left), right=rename(e.right)) for e in equations])


def _assertions(assertions: tuple[Assertion, ...], rename: _Rename) -> tuple[Assertion, ...]:
    return tuple([replace(a, condition=rename(a.condition), message=rename(a.message)) for a in assertions])


def _when(when: When, rename: _Rename) -> When:
    return replace(when, branches=tuple([_branch(branch, rename) for branch in when.branches]))


def _branch(branch: WhenBranch, rename: _Rename) -> WhenBranch:
    def reinit(item: Reinit) -> Reinit:
        return replace(item, state=rename(item.state), value=rename(item.value))

    def termination(item: Termination) -> Termination:
        return replace(item, message=rename(item.message))

    return replace(
        branch,
        conditions=tuple([rename(condition) for condition in branch.conditions]),
        equations=_equations(branch.equations, rename),
        reinits=tuple([reinit(item) for item in branch.reinits]),
        assertions=_assertions(branch.assertions, rename),
        terminations=tuple([termination(item) for item in branch.terminations]),
    )


def _protected(definition: ast.ClassDefinition) -> Iterator[str]:
    """Names of the variables with `annotation(Protected = true)`, which `print_flat` writes."""
    elements = definition.body.elements if isinstance(definition, ast.LongClass) else ()
    for element in elements:
        for declaration in element.declarations if isinstance(element, ast.ComponentClause) else ():
            notes = declaration.comment.annotation
            for argument in () if notes is None else notes.arguments:
                if isinstance(argument, ast.ElementModification) and argument.name == ("Protected",):
                    yield declaration.name
