"""Predefined types, enumerations and the type definitions derived from them (Modelica 3.6, 4.9)."""

from __future__ import annotations

from acausal.errors import AcausalError, TypeProblem, UnsupportedProblem, fail
from acausal.lang import ast
from acausal.lang.flat import BOOLEAN, INTEGER, REAL, STRING, Causality, ScalarType
from acausal.lang.light import light_object
from acausal.lang.modifiers import NO_MODIFIER, Binding, Modifier, merge, overrides_final
from acausal.lang.predefined import EXTERNAL_OBJECT
from acausal.lang.scope import Scope

_SCALAR_TYPES = {"Real": REAL, "Integer": INTEGER, "Boolean": BOOLEAN, "String": STRING}
_EXTERNAL = ScalarType(EXTERNAL_OBJECT, (), True)
_REAL_ATTRIBUTES = (
    "quantity", "unit", "displayUnit", "min", "max", "start", "fixed", "nominal", "unbounded", "stateSelect",
)  # fmt: skip
_ATTRIBUTES = {
    "Real": _REAL_ATTRIBUTES,
    "Integer": ("quantity", "min", "max", "start", "fixed"),
    "Boolean": ("quantity", "start", "fixed"),
    "String": ("quantity", "start", "fixed"),
}
_ENUMERATION_ATTRIBUTES = ("quantity", "min", "max", "start", "fixed")
CAUSALITY = {"": Causality.LOCAL, "input": Causality.INPUT, "output": Causality.OUTPUT}


@light_object
class SimpleType:
    """A predefined or enumeration type reached through type definitions, with what they add on the way.

    `dimensions` are those of array types with the class they are written in, outermost first. `spread` holds
    attributes of such array types, to be split over the elements of their dimensions, whose number stands
    beside them: `type V = Real[3](min = {1, 2, 3})`.
    """

    scalar: ScalarType
    attributes: dict[str, Binding]
    final: frozenset[str]
    dimensions: tuple[tuple[ast.Subscripts, Scope], ...]
    causality: Causality
    connector: bool = False
    spread: tuple[tuple[Modifier, int], ...] = ()


class SimpleTypes:
    """What classes boil down to, each found once."""

    def __init__(self) -> None:
        self._found: dict[Scope, SimpleType | None] = {}

    def of(self, scope: Scope) -> SimpleType | None:
        """The simple type of a class; None for a class with components, or an empty one."""
        if scope not in self._found:
            self._found[scope] = self._find(scope)
        return self._found[scope]

    def _find(self, scope: Scope) -> SimpleType | None:
        if isinstance(scope.definition, ast.EnumerationClass):
            return SimpleType(enumeration_of(scope), {}, frozenset(), (), Causality.LOCAL)
        if scope.is_predefined:
            if scope.path == EXTERNAL_OBJECT:
                return SimpleType(_EXTERNAL, {}, frozenset(), (), Causality.LOCAL)
            return SimpleType(_SCALAR_TYPES[scope.path], {}, frozenset(), (), Causality.LOCAL)
        table = scope.table
        if len(table.bases) != 1 or table.components:
            return None
        simple = self.of(table.bases[0].scope)
        if simple is not None and simple.scalar is _EXTERNAL:
            return SimpleType(ScalarType(scope.path, (), True), {}, frozenset(), (), Causality.LOCAL)
        return None if simple is None else _derived(scope, simple)


def _derived(scope: Scope, simple: SimpleType) -> SimpleType:
    """`type T = Base[n](modification)`."""
    base = scope.table.bases[0]
    modifier = merge(scope.modifier, base.modifier)
    final = set(simple.final)
    for name, child in modifier.children.items():
        if child.final:
            final.add(name)
    dimensions = simple.dimensions
    if base.dimensions is not None:
        dimensions = ((base.dimensions, base.where), *dimensions)
    spread = simple.spread
    if dimensions:
        modifier, split = _split(modifier)
        with_attributes(simple, split, scope.path)
        if not split.is_empty:
            rank = sum(len(subscripts.items) for subscripts, _ in dimensions)
            spread = ((split, rank), *spread)
    attributes = with_attributes(simple, modifier, scope.path)
    causality = simple.causality
    definition = scope.definition
    if isinstance(definition, ast.ShortClass) and definition.causality:
        causality = CAUSALITY[definition.causality]
    connector = simple.connector or scope.kind == "connector"
    return SimpleType(simple.scalar, attributes, frozenset(final), dimensions, causality, connector, spread)


def _split(modifier: Modifier) -> tuple[Modifier, Modifier]:
    """The attributes that hold for each element, and those given for the whole array."""
    each = {n: c for n, c in modifier.children.items() if c.binding is None or c.binding.each}
    rest = {n: c for n, c in modifier.children.items() if n not in each}
    return Modifier(children=each), Modifier(children=rest) if rest else NO_MODIFIER


def with_attributes(simple: SimpleType, modifier: Modifier, path: str) -> dict[str, Binding]:
    """The attributes of a type with a modification over them. Raises `modification.*`."""
    if not modifier.children:
        return simple.attributes
    attributes = dict(simple.attributes)
    allowed = attributes_of(simple.scalar)
    for name, child in modifier.children.items():
        if name not in allowed:
            raise _unknown_attribute(path, name, simple.scalar, child)
        if name in simple.final:
            where = attributes[name].span if name in attributes else None
            raise overrides_final(f"{path}.{name}", child.span, where)
        if child.redeclaration is not None or child.children:
            raise _unknown_attribute(path, name, simple.scalar, child)
        if child.binding is not None:
            attributes[name] = child.binding
    return attributes


def attributes_of(type_: ScalarType) -> tuple[str, ...]:
    """Names of the attributes of a type."""
    return _ENUMERATION_ATTRIBUTES if type_.is_enumeration else _ATTRIBUTES.get(type_.name, ())


def enumeration_of(scope: Scope) -> ScalarType:
    """The scalar type of an enumeration class."""
    definition = scope.definition
    assert isinstance(definition, ast.EnumerationClass)
    if definition.literals is None:
        raise fail(
            UnsupportedProblem,
            "unsupported.open-enumeration",
            f"`{scope.path}` is `enumeration(:)`: it has no literals until it is redeclared",
            scope.span,
            names=[scope.path],
        )
    names = tuple([entry.name for entry in definition.literals])
    seen: set[str] = set()
    for entry in definition.literals:
        if entry.name in seen:
            raise fail(
                TypeProblem,
                "lookup.duplicate-element",
                f"the literal `{entry.name}` is listed twice in `{scope.path}`",
                entry.span,
                names=[entry.name],
                hint="remove one of them",
            )
        if entry.name in _ENUMERATION_ATTRIBUTES:
            raise fail(
                TypeProblem,
                "class.literal",
                f"`{entry.name}` is an attribute of every enumeration, so it is no literal of `{scope.path}`",
                entry.span,
                names=[entry.name],
                hint="use another name (Modelica 3.6, 4.9.5.1)",
            )
        seen.add(entry.name)
    return ScalarType(scope.path, names)


def _unknown_attribute(path: str, name: str, type_: ScalarType, child: Modifier) -> AcausalError:
    return fail(
        TypeProblem,
        "modification.unknown-attribute",
        f"`{path}` is of type {type_}, which has no attribute `{name}`",
        child.span,
        names=[path, name],
        hint=f"attributes of {type_}: {', '.join(attributes_of(type_))}",
    )
