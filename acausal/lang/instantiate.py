"""From a class to its instance tree: modifiers merged, types found, sizes and conditions decided.

Members are built when they are first asked for, because a size may depend on a parameter declared later;
`instantiate` asks for all of them in the end.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from math import prod

from acausal.errors import LookupProblem, Span, TypeProblem, UnsupportedProblem, fail
from acausal.lang import ast
from acausal.lang.flat import BOOLEAN, INTEGER, REAL, STRING, Causality, ScalarType, Variability
from acausal.lang.instance import Absent, Array, Connection, Instance, Leaf, Member, Prefixes
from acausal.lang.modifiers import (
    NO_MODIFIER,
    Binding,
    Context,
    Modifier,
    bound,
    element_of,
    merge,
    modifier_of,
    overrides_final,
    strip_first,
)
from acausal.lang.scope import EXTERNAL_OBJECT, ComponentEntry, Root, Scope, unknown_target

MAX_DEPTH = 100
"""Components nested deeper than this are taken for a model that contains itself."""
MAX_ELEMENTS = 2_000_000
"""Bound on the elements of one array component."""

Evaluator = Callable[[ast.Expression, Context, str], object]
"""Compile-time value of an expression; the text says what it is needed for."""

_SCALAR_TYPES = {"Real": REAL, "Integer": INTEGER, "Boolean": BOOLEAN, "String": STRING}
_ATTRIBUTES = {
    "Real": ("value", "quantity", "unit", "displayUnit", "min", "max", "start", "fixed", "nominal", "unbounded", "stateSelect"),
    "Integer": ("value", "quantity", "min", "max", "start", "fixed"),
    "Boolean": ("value", "quantity", "start", "fixed"),
    "String": ("value", "quantity", "start", "fixed"),
}
_ENUMERATION_ATTRIBUTES = ("value", "quantity", "min", "max", "start", "fixed")
_VARIABILITY = {
    "": Variability.CONTINUOUS,
    "discrete": Variability.DISCRETE,
    "parameter": Variability.PARAMETER,
    "constant": Variability.CONSTANT,
}
_CAUSALITY = {"": Causality.LOCAL, "input": Causality.INPUT, "output": Causality.OUTPUT}


@dataclass(frozen=True, slots=True)
class SimpleType:
    """A predefined or enumeration type reached through type definitions, with what they add on the way."""

    scalar: ScalarType
    attributes: dict[str, Binding]
    final: frozenset[str]
    dimensions: tuple[tuple[ast.Subscripts, Scope], ...]
    causality: Causality


class Instantiator:
    """Builds members on demand; `evaluate` is the translator's compile-time evaluation."""

    def __init__(self, root: Root, evaluate: Evaluator) -> None:
        self.root = root
        self.evaluate = evaluate
        self._simple: dict[Scope, SimpleType | None] = {}
        self._packages: dict[Scope, Instance] = {}
        self._building: list[tuple[Instance, str]] = []

    # ------------------------------------------------------------------ roots

    def model(self, scope: Scope, modifier: Modifier) -> Instance:
        """The top-level instance; its path is empty."""
        scope = scope.modified(modifier)
        self._check_targets(scope, modifier)
        return Instance("", scope, None, Prefixes(), scope.span, description_of(scope), modifier)

    def package(self, scope: Scope) -> Instance:
        """The instance that holds a package's (or class's) constants."""
        found = self._packages.get(scope)
        if found is None:
            found = Instance(scope.path, scope, None, Prefixes(), scope.span, "", scope.modifier)
            self._packages[scope] = found
        return found

    def complete(self, root: Instance) -> Instance:
        """Build every member below `root`."""
        stack: list[tuple[Member, int]] = [(root, 0)]
        while stack:
            member, depth = stack.pop()
            if isinstance(member, Instance):
                if depth > MAX_DEPTH:
                    raise _too_deep(member)
                for name in member.scope.table.components:
                    self.member(member, name)
                order = {name: member.members[name] for name in member.scope.table.components}
                member.members.clear()
                member.members.update(order)
                stack.extend((m, depth + 1) for m in member.members.values() if not isinstance(m, Leaf))
            elif isinstance(member, Array):
                stack.extend((m, depth + 1) for m in member.items if not isinstance(m, Leaf))
        return root

    # ------------------------------------------------------------------ members

    def member(self, instance: Instance, name: str) -> Member | None:
        """The member `name`, built now if need be; None if the class has no such component."""
        found = instance.members.get(name)
        if found is not None:
            return found
        entry = instance.scope.table.components.get(name)
        if entry is None:
            return None
        key = (instance, name)
        if key in self._building:
            raise _cyclic_structure(entry, instance)
        self._building.append(key)
        try:
            built = self._build(entry, instance)
        finally:
            self._building.pop()
        instance.members[name] = built
        return built

    def _build(self, entry: ComponentEntry, instance: Instance) -> Member:
        path = f"{instance.path}.{entry.name}" if instance.path else entry.name
        modifier = self._modifier(entry, instance, path)
        clause, declaration, where = entry.clause, entry.declaration, entry.scope
        context = Context(where, instance)
        if declaration.condition is not None:
            if not self.evaluate(declaration.condition, context, f"the condition of `{path}`"):
                return Absent(path, declaration.span)
        if modifier.redeclaration is not None:
            clause, declaration, where, modifier = _redeclare(entry, modifier, path)
            context = Context(where, modifier.redeclaration.context.instance or instance) if modifier.redeclaration else context
            modifier = replace(modifier, redeclaration=None)
        modifier = self._with_declaration(modifier, declaration, context, path)
        _refuse_unsupported(clause, path)
        type_scope = where.find_class(clause.type)
        plan = _Plan(path, clause, declaration, context, _prefixes(entry, clause, instance), modifier)
        return self._shaped(plan, type_scope, instance)

    def _modifier(self, entry: ComponentEntry, instance: Instance, path: str) -> Modifier:
        """Modifiers from outside the declaring class: the component's own, then those of extends clauses."""
        modifier = instance.modifier.child(entry.name)
        for arguments, scope in entry.through:
            modifier = merge(modifier, strip_first(arguments, Context(scope, instance)), path)
        if not modifier.is_empty and entry.clause.prefixes.final and _overrides(modifier):
            raise overrides_final(path, modifier.span, entry.declaration.span)
        return modifier

    def _with_declaration(
        self, modifier: Modifier, declaration: ast.Declaration, context: Context, path: str
    ) -> Modifier:
        if declaration.modification is None:
            return modifier
        own = modifier_of(declaration.modification, context)
        return own if modifier.is_empty else merge(modifier, own, path)

    def _shaped(self, plan: _Plan, type_scope: Scope, instance: Instance) -> Member:
        simple = self.simple_type(type_scope)
        shape = self._shape(plan, plan.declaration.dimensions, plan.context)
        shape += self._shape(plan, plan.clause.dimensions, plan.context)
        if simple is not None:
            for dimensions, scope in simple.dimensions:
                shape += self._shape(plan, dimensions, Context(scope, None))
            return self._array(plan, shape, simple.scalar, lambda p: self._leaf(p, simple))
        return self._array(plan, shape, None, lambda p: self._component(p, type_scope, instance))

    def _shape(self, plan: _Plan, dimensions: ast.Subscripts | None, context: Context) -> tuple[int, ...]:
        if dimensions is None:
            return ()
        sizes: list[int] = []
        for position, item in enumerate(dimensions.items):
            if isinstance(item, ast.Colon):
                sizes.append(self._size_from_binding(plan, position))
                continue
            size = self.evaluate(item, context, f"the size of `{plan.path}`")
            if not isinstance(size, int) or isinstance(size, bool) or size < 0:
                raise _bad_size(plan.path, size, item)
            sizes.append(size)
        if prod(sizes) > MAX_ELEMENTS:
            raise _bad_size(plan.path, prod(sizes), dimensions.items[0])
        return tuple(sizes)

    def _size_from_binding(self, plan: _Plan, position: int) -> int:
        binding = plan.modifier.binding
        if binding is None:
            raise fail(
                TypeProblem,
                "array.unknown-size",
                f"the size of `{plan.path}` is `:` and there is no value to take it from",
                plan.declaration.span,
                names=[plan.path],
                hint="give it a value or a size",
            )
        size = self.evaluate(_size_call(binding.expression, position), binding.context, f"the size of `{plan.path}`")
        assert isinstance(size, int)
        return size

    def _array(
        self, plan: _Plan, shape: tuple[int, ...], scalar: ScalarType | None, build: Callable[[_Plan], Member]
    ) -> Member:
        if not shape:
            return build(plan)
        items: list[Member] = []

        def fill(path: str, modifier: Modifier, depth: int) -> None:
            if depth == len(shape):
                items.append(build(replace(plan, path=f"{plan.path}[{path}]", modifier=modifier)))
                return
            for i in range(shape[depth]):
                name = f"{path},{i + 1}" if path else str(i + 1)
                fill(name, element_of(modifier, i), depth + 1)

        fill("", plan.modifier, 0)
        return Array(plan.path, shape, tuple(items), scalar, plan.declaration.span)

    def _leaf(self, plan: _Plan, simple: SimpleType) -> Leaf:
        attributes = dict(simple.attributes)
        allowed = _ENUMERATION_ATTRIBUTES if simple.scalar.is_enumeration else _ATTRIBUTES[simple.scalar.name]
        for name, child in plan.modifier.children.items():
            if name not in allowed:
                raise _unknown_attribute(plan.path, name, simple.scalar, child)
            if name in simple.final:
                raise overrides_final(f"{plan.path}.{name}", child.span, attributes[name].span)
            if child.binding is not None:
                attributes[name] = child.binding
        prefixes = plan.prefixes
        if prefixes.causality is Causality.LOCAL and simple.causality is not Causality.LOCAL:
            prefixes = replace(prefixes, causality=simple.causality)
        return Leaf(
            plan.path,
            simple.scalar,
            _discrete_default(prefixes, simple.scalar),
            attributes,
            plan.modifier.binding,
            plan.declaration.span,
            plan.declaration.comment.text or "",
        )

    def _component(self, plan: _Plan, type_scope: Scope, parent: Instance) -> Instance:
        scope = type_scope.modified(plan.modifier)
        _check_instantiable(scope, plan)
        modifier = plan.modifier
        if not type_scope.modifier.is_empty:
            modifier = merge(modifier, bound(type_scope.modifier, parent), plan.path)
        self._check_targets(scope, modifier)
        modifier = _spread_record(modifier, scope)
        prefixes = _inherit_kind(plan.prefixes, scope)
        description = plan.declaration.comment.text or ""
        if plan.path.count(".") > MAX_DEPTH:
            raise _too_deep(parent)
        return Instance(plan.path, scope, parent, prefixes, plan.declaration.span, description, modifier)

    def _check_targets(self, scope: Scope, modifier: Modifier) -> None:
        for name, child in modifier.children.items():
            if name not in scope.table.components and scope.find_local(name) is None:
                raise unknown_target(name, scope, child.span or scope.span)

    # ------------------------------------------------------------------ simple types

    def simple_type(self, scope: Scope) -> SimpleType | None:
        """What a type boils down to if it is (derived from) a predefined type or an enumeration."""
        if scope not in self._simple:
            self._simple[scope] = self._find_simple_type(scope)
        return self._simple[scope]

    def _find_simple_type(self, scope: Scope) -> SimpleType | None:
        definition = scope.definition
        if isinstance(definition, ast.EnumerationClass):
            return SimpleType(enumeration_of(scope), {}, frozenset(), (), Causality.LOCAL)
        if scope.is_predefined and scope.path == EXTERNAL_OBJECT:
            return None
        if scope.is_predefined:
            return SimpleType(_SCALAR_TYPES[scope.path], {}, frozenset(), (), Causality.LOCAL)
        table = scope.table
        if len(table.bases) != 1 or table.components:
            return None
        base = table.bases[0]
        simple = self.simple_type(base.scope)
        if simple is None:
            return None
        modifier = merge(scope.modifier, modifier_of(base.modification, Context(scope.enclosing or scope, None)))
        attributes = dict(simple.attributes)
        allowed = _ENUMERATION_ATTRIBUTES if simple.scalar.is_enumeration else _ATTRIBUTES[simple.scalar.name]
        final = set(simple.final)
        for name, child in modifier.children.items():
            if name not in allowed:
                raise _unknown_attribute(scope.path, name, simple.scalar, child)
            if name in simple.final:
                raise overrides_final(f"{scope.path}.{name}", child.span, attributes[name].span)
            if child.binding is not None:
                attributes[name] = child.binding
            if child.final:
                final.add(name)
        dimensions = simple.dimensions
        if base.dimensions is not None:
            dimensions = ((base.dimensions, scope.enclosing or scope), *dimensions)
        causality = simple.causality
        if isinstance(definition, ast.ShortClass) and definition.causality:
            causality = _CAUSALITY[definition.causality]
        return SimpleType(simple.scalar, attributes, frozenset(final), dimensions, causality)


@dataclass(frozen=True, slots=True)
class _Plan:
    """A component about to be built."""

    path: str
    clause: ast.ComponentClause
    declaration: ast.Declaration
    context: Context
    prefixes: Prefixes
    modifier: Modifier


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
    return ScalarType(scope.path, tuple([entry.name for entry in definition.literals]))


def description_of(scope: Scope) -> str:
    """The description string of a class."""
    definition = scope.definition
    if isinstance(definition, ast.LongClass):
        return definition.comment or ""
    return definition.comment.text or ""


def _redeclare(
    entry: ComponentEntry, modifier: Modifier, path: str
) -> tuple[ast.ComponentClause, ast.Declaration, Scope, Modifier]:
    redeclaration = modifier.redeclaration
    assert redeclaration is not None
    element = redeclaration.element
    if not entry.clause.prefixes.replaceable:
        raise fail(
            TypeProblem,
            "redeclare.not-replaceable",
            f"`{path}` is not replaceable and cannot be redeclared",
            redeclaration.span,
            names=[path],
            hint=f"declare it `replaceable` at {entry.declaration.span}",
        )
    if not isinstance(element, ast.ComponentClause):
        raise fail(
            TypeProblem, "redeclare.kind", f"`{path}` is a component, but it is redeclared as a class", redeclaration.span, names=[path]
        )
    constraint = entry.clause.constraint
    if constraint is not None and constraint.modification is not None:
        inner = modifier_of(constraint.modification, Context(entry.scope, redeclaration.context.instance))
        modifier = merge(modifier, inner, path)
    return element, element.declarations[0], redeclaration.context.scope, modifier


def _overrides(modifier: Modifier) -> bool:
    return modifier.binding is not None or modifier.redeclaration is not None


def _prefixes(entry: ComponentEntry, clause: ast.ComponentClause, instance: Instance) -> Prefixes:
    outer = instance.prefixes
    connection = {"": Connection.POTENTIAL, "flow": Connection.FLOW, "stream": Connection.STREAM}[clause.flow]
    causality = _CAUSALITY[clause.causality]
    return Prefixes(
        min(outer.variability, _VARIABILITY[clause.variability]),
        causality if causality is not Causality.LOCAL else outer.causality,
        connection if connection is not Connection.POTENTIAL else outer.connection,
        outer.protected or entry.protected,
        clause.prefixes.final,
    )


def _inherit_kind(prefixes: Prefixes, scope: Scope) -> Prefixes:
    """Input and output reach into connectors and records, not into models."""
    if scope.kind in ("model", "block", "class"):
        return replace(prefixes, causality=Causality.LOCAL)
    return prefixes


def _discrete_default(prefixes: Prefixes, type_: ScalarType) -> Prefixes:
    """Variables that are not Real change only at events (Modelica 3.6, 4.5)."""
    if prefixes.variability is Variability.CONTINUOUS and type_ != REAL:
        return replace(prefixes, variability=Variability.DISCRETE)
    return prefixes


def _spread_record(modifier: Modifier, scope: Scope) -> Modifier:
    """A record's value becomes the value of each field that has none of its own."""
    if modifier.binding is None or scope.kind != "record":
        return modifier
    children = dict(modifier.children)
    for name in scope.table.components:
        child = children.get(name, NO_MODIFIER)
        if child.binding is None:
            children[name] = replace(child, binding=modifier.binding.part(name))
    return replace(modifier, children=children)


def _size_call(expression: ast.Expression, position: int) -> ast.Call:
    """`size(expression, position + 1)`."""
    span = expression.span
    name = ast.ComponentReference((ast.NamePart("size", None, span),), False, span)
    return ast.Call(name, (expression, ast.IntegerLiteral(position + 1, span)), (), (), span)


def _check_instantiable(scope: Scope, plan: _Plan) -> None:
    definition = scope.definition
    if scope.kind in ("package", "function"):
        raise fail(
            TypeProblem,
            "type.not-a-component-type",
            f"`{plan.path}` is declared with the {scope.kind} `{scope.path}` as its type",
            plan.clause.type.span,
            names=[plan.path],
            hint="use a model, block, connector, record or type",
        )
    if definition.class_prefixes.partial:
        raise fail(
            TypeProblem,
            "type.partial",
            f"`{plan.path}` is of the partial class `{scope.path}`, which cannot be instantiated",
            plan.clause.type.span,
            names=[plan.path],
            hint="redeclare it with a class that extends the partial one",
        )
    if any(base.scope.path == EXTERNAL_OBJECT for base in scope.table.bases):
        raise fail(
            UnsupportedProblem,
            "unsupported.external-object",
            f"`{plan.path}` is the external object `{scope.path}`, which is not supported yet",
            plan.clause.type.span,
            names=[plan.path],
        )
    if definition.class_prefixes.expandable:
        raise fail(
            UnsupportedProblem,
            "unsupported.expandable",
            f"`{plan.path}` is an expandable connector, which is not supported yet",
            plan.clause.type.span,
            names=[plan.path],
        )


def _refuse_unsupported(clause: ast.ComponentClause, path: str) -> None:
    for used, what in (
        (clause.prefixes.inner, "inner"),
        (clause.prefixes.outer, "outer"),
        (clause.flow == "stream", "stream"),
    ):
        if used:
            raise fail(
                UnsupportedProblem,
                f"unsupported.{what}",
                f"`{path}` is declared `{what}`, which is not supported yet",
                clause.span,
                names=[path],
            )


def _too_deep(instance: Instance) -> TypeProblem:
    error = fail(
        TypeProblem,
        "instance.recursive",
        f"`{instance.scope.path}` contains itself: components are nested more than {MAX_DEPTH} deep",
        instance.span,
        names=[instance.scope.path],
        hint="a model cannot have a component of its own class",
    )
    assert isinstance(error, TypeProblem)
    return error


def _cyclic_structure(entry: ComponentEntry, instance: Instance) -> LookupProblem:
    path = f"{instance.path}.{entry.name}" if instance.path else entry.name
    error = fail(
        LookupProblem,
        "parameter.cyclic",
        f"the size, condition or type of `{path}` depends on itself",
        entry.declaration.span,
        names=[path],
        hint="break the circle of parameters",
    )
    assert isinstance(error, LookupProblem)
    return error


def _bad_size(path: str, size: object, item: ast.Expression) -> TypeProblem:
    error = fail(
        TypeProblem,
        "array.bad-size",
        f"the size of `{path}` is {size}; it must be an Integer from 0 to {MAX_ELEMENTS}",
        item.span,
        names=[path],
    )
    assert isinstance(error, TypeProblem)
    return error


def _unknown_attribute(path: str, name: str, type_: ScalarType, child: Modifier) -> TypeProblem:
    allowed = _ENUMERATION_ATTRIBUTES if type_.is_enumeration else _ATTRIBUTES[type_.name]
    error = fail(
        TypeProblem,
        "modification.unknown-attribute",
        f"`{path}` is of type {type_}, which has no attribute `{name}`",
        child.span,
        names=[path],
        hint=f"attributes of {type_}: {', '.join(allowed[1:])}",
    )
    assert isinstance(error, TypeProblem)
    return error


