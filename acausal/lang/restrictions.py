"""What a class may contain and derive from, judged by its text (Modelica 3.6, 4.5.3, 4.6 and 7.1.3).

`check_class` looks at one class's own elements and sections, `check_base` at one pair of derived and base
class. Both know nothing of components' types; what depends on those is judged where components are built.
Linear in the text of the class, once per class.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING

from acausal.errors import AcausalError, Span, TypeProblem, fail
from acausal.lang import ast
from acausal.lang.restrictions_bodies import check_no_time, check_sections

if TYPE_CHECKING:  # a scope builds its table, which is checked here
    from acausal.lang.class_table import Table
    from acausal.lang.scope import Scope

_SECTIONLESS = ("record", "connector", "package", "type", "operator")
_NO_PROTECTED = ("record", "connector")
_TIMELESS = ("record", "connector", "package")


def kind_name(definition: ast.ClassDefinition) -> str:
    """The specialised class as it is written: `operator record`, `expandable connector`, `model`."""
    prefixes = definition.class_prefixes
    if prefixes.operator:
        return f"operator {definition.kind}"
    return f"expandable {definition.kind}" if prefixes.expandable else definition.kind


def check_class(scope: Scope) -> None:
    """The class's own text. Raises `TypeProblem` `class.*`, `equation.*`, `statement.*`, `function.*`."""
    definition = scope.definition
    _check_place(scope)
    if not isinstance(definition, ast.LongClass):
        return
    _check_imports(definition)
    kind = definition.kind
    _check_sections(scope, definition)
    for element in definition.body.elements:
        if isinstance(element, ast.Extends):
            continue
        if isinstance(element, ast.ComponentClause):
            _check_clause(scope, element)
        elif kind == "operator" and isinstance(element, ast.ClassDefinition) and element.kind != "function":
            raise _class_error(
                "class.element", scope, "may only contain functions", element.span, (element.name,)
            )
        if isinstance(element, ast.ComponentClause) and kind in _TIMELESS:
            check_no_time(element, scope.path, kind)
        if kind in _NO_PROTECTED and _is_protected(element):
            names = tuple(_names(element))
            raise _class_error("class.protected", scope, "has no protected elements", element.span, names)
    check_sections(definition, scope.path)


def _class_error(
    code: str, scope: Scope, what: str, span: Span, names: tuple[str, ...] = (), section: str = "4.6"
) -> AcausalError:
    kind = kind_name(scope.definition)
    article = "an" if kind[0] in "aeio" else "a"
    message = f"`{scope.path}` is {article} {kind}, which {what}"
    return fail(
        TypeProblem,
        code,
        message,
        span,
        names=names or (scope.path,),
        hint=f"see Modelica 3.6, {section}: restrictions of specialized classes",
    )


def _is_protected(element: ast.Element) -> bool:
    return not isinstance(element, (ast.Import, ast.Extends)) and element.prefixes.protected


def _names(element: ast.Element) -> Iterator[str]:
    if isinstance(element, ast.ComponentClause):
        yield from [declaration.name for declaration in element.declarations]
    elif isinstance(element, ast.ClassDefinition):
        yield element.name


# --------------------------------------------------------------------------- names


def _check_imports(definition: ast.LongClass) -> None:
    """No two imports make the same name visible (13.2.1.1)."""
    seen: dict[str, Span] = {}
    for element in definition.body.elements:
        if not isinstance(element, ast.Import) or element.wildcard:
            continue
        for name in element.group or (element.alias or element.name[-1],):
            if name in seen:
                raise fail(
                    TypeProblem,
                    "import.duplicate",
                    f"two imports make the name `{name}` visible",
                    element.span,
                    names=[name],
                    hint=f"the first is at {seen[name]}; rename one: `import Other = ...` (13.2.1.1)",
                )
            seen[name] = element.span


# --------------------------------------------------------------------------- places and sections


def _check_place(scope: Scope) -> None:
    """`operator` and `operator function` stand directly in an operator record."""
    definition = scope.definition
    kind = kind_name(definition)
    if kind not in ("operator", "operator function") and definition.kind != "operator":
        return
    around = scope.node.parent
    if around is None or kind_name(around.definition) != "operator record":
        raise _class_error("class.place", scope, "may only stand in an operator record", scope.span)


def _check_sections(scope: Scope, definition: ast.LongClass) -> None:
    kind, body = definition.kind, definition.body
    if body.external is not None and kind != "function":
        raise _class_error("class.external", scope, "cannot be external", body.external.span)
    algorithms = 0
    for section in body.sections:
        if kind in _SECTIONLESS:
            raise _class_error("class.section", scope, f"has no {_section_name(section)}", section.span)
        if kind != "function":
            continue
        if isinstance(section, ast.EquationSection) or section.initial:
            what = f"has no {_section_name(section)}"
            raise _class_error("function.section", scope, what, section.span, section="12.2")
        algorithms += 1
        if algorithms > 1 or body.external is not None:
            what = "has one algorithm section or one external interface"
            raise _class_error("function.section", scope, what, section.span, section="12.2")


def _section_name(section: ast.EquationSection | ast.AlgorithmSection) -> str:
    what = "equations" if isinstance(section, ast.EquationSection) else "algorithm"
    return f"initial {what}" if section.initial else what


# --------------------------------------------------------------------------- components


def _check_clause(scope: Scope, clause: ast.ComponentClause) -> None:
    rule = _CLAUSES.get(scope.kind)
    what = _general(clause) or ("" if rule is None else rule(clause))
    if what:
        names = tuple(_names(clause))
        raise _class_error("class.component", scope, what, clause.span, names)


def _general(clause: ast.ComponentClause) -> str:
    """Prefixes that exclude each other in every class (4.4.2.2)."""
    if clause.causality == "input" and clause.variability in ("parameter", "constant"):
        return f"cannot have an input that is a {clause.variability} (4.4.2.2)"
    if clause.flow and clause.variability in ("parameter", "constant"):
        return f"cannot have a {clause.variability} with the prefix `{clause.flow}` (4.4.2.2)"
    return ""


def _in_record(clause: ast.ComponentClause) -> str:
    for prefix in (clause.causality, clause.flow):
        if prefix:
            return f"has no elements with the prefix `{prefix}`"
    return _without_inner(clause)


def _without_inner(clause: ast.ComponentClause) -> str:
    prefixes = clause.prefixes
    if prefixes.inner or prefixes.outer:
        return f"has no elements with the prefix `{'inner' if prefixes.inner else 'outer'}`"
    return ""


def _in_package(clause: ast.ComponentClause) -> str:
    return "" if clause.variability == "constant" else "may only contain classes and constants"


def _in_function(clause: ast.ComponentClause) -> str:
    if clause.flow:
        return f"has no elements with the prefix `{clause.flow}`"
    if clause.prefixes.protected and clause.causality:
        return f"has no protected {clause.causality}: its formal parameters are public (12.2)"
    return _without_inner(clause)


def _nothing(_clause: ast.ComponentClause) -> str:
    return "has no components of its own"


_CLAUSES: dict[str, Callable[[ast.ComponentClause], str]] = {
    "record": _in_record,
    "connector": _without_inner,
    "package": _in_package,
    "function": _in_function,
    "type": _nothing,
    "operator": _nothing,
}


# --------------------------------------------------------------------------- bases

_OTHER_BASES: dict[str, tuple[str, ...]] = {
    "operator function": ("function",),
    "connector": ("type", "record", "operator record"),
    "block": ("record",),
    "model": ("record", "block"),
    "class": ("record", "block", "model"),
}
"""Beside the own kind and `class`; the last line is the deprecated use of `class` for a model (7.1.3)."""


def check_base(scope: Scope, base: Scope, span: Span) -> None:
    """The table of 7.1.3, and 4.6 on operator records. Raises `extends.kind`."""
    derived, other = kind_name(scope.definition), kind_name(base.definition)
    if other not in (derived, "class") and other not in _OTHER_BASES.get(derived, ()):
        raise _bad_base(scope, base, span, f"{_a(derived)} cannot extend {_a(other)}")
    if other == "package" and _holds_operator_record(base.definition):
        raise _bad_base(scope, base, span, "it contains an operator record, which would be inherited (4.6)")
    if other == "operator record" and isinstance(scope.definition, ast.LongClass):
        raise _bad_base(scope, base, span, "only a short class definition may extend an operator record")


def _holds_operator_record(definition: ast.ClassDefinition) -> bool:
    """Whether a class of the text is an operator record; short definitions of one are none (4.6)."""
    if not isinstance(definition, ast.LongClass):
        return False
    inside = [element for element in definition.body.elements if isinstance(element, ast.LongClass)]
    return any(kind_name(element) == "operator record" for element in inside)


def _a(kind: str) -> str:
    return f"{'an' if kind[0] in 'aeio' else 'a'} {kind}"


def _bad_base(scope: Scope, base: Scope, span: Span, why: str) -> AcausalError:
    return fail(
        TypeProblem,
        "extends.kind",
        f"`{scope.path}` cannot extend `{base.path}`: {why}",
        span,
        names=[scope.path, base.path],
        hint="see the table of base classes in Modelica 3.6, 7.1.3",
    )


def check_combination(scope: Scope, table: Table) -> None:
    """What extends a simple type, an array class or a class with prefixes has nothing else (4.5.2).

    Raises `extends.combination`.
    """
    definition = scope.definition
    if not isinstance(definition, ast.LongClass):
        return
    base = next((base for base in table.bases if _is_closed(base.scope)), None)
    table.closed = base is not None
    if base is None:
        return
    others = [e for e in definition.body.elements if isinstance(e, (ast.Extends, ast.ComponentClause))]
    others = [e for e in others if e.span is not base.span]
    span = others[0].span if others else None
    if span is None and definition.body.sections:
        span = definition.body.sections[0].span
    if span is not None:
        raise fail(
            TypeProblem,
            "extends.combination",
            f"`{scope.path}` extends `{base.scope.path}`, which cannot be combined with anything else",
            span,
            names=[scope.path, base.scope.path],
            hint="simple types, array classes and those with `input` or `output` are extended alone (4.5.2)",
        )


def _is_closed(scope: Scope) -> bool:
    """A simple type, an array class, a class with a prefix, or what extends one."""
    if scope.is_predefined:
        return scope.definition.kind == "type"
    table = scope.table
    if table.closed is None:  # that of what it inherits from is known already
        table.closed = _is_closed_itself(scope.definition) or any(
            _is_closed(base.scope) for base in table.bases
        )
    return table.closed


def _is_closed_itself(definition: ast.ClassDefinition) -> bool:
    if isinstance(definition, ast.ShortClass):
        return bool(definition.causality) or definition.dimensions is not None
    return isinstance(definition, ast.EnumerationClass)
