"""What a class contains: own and inherited elements, with the modifications of `extends` clauses.

Inherited elements become part of the derived class (Modelica 3.6, 7.1); the same element inherited twice
counts once (7.1.2); a `redeclare` element replaces the inherited one of its name (7.3).
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from acausal.errors import AcausalError, LookupProblem, Span, TypeProblem, fail
from acausal.lang import ast
from acausal.lang.access import check_not_replaceable
from acausal.lang.library import ClassNode
from acausal.lang.light import light_object
from acausal.lang.lookup_errors import class_extends, duplicate, unknown_target
from acausal.lang.modifiers import (
    NO_MODIFIER,
    Context,
    Modifier,
    merge,
    modifier_of,
    not_replaceable,
    redeclaration_of,
    same_contents,
)
from acausal.lang.redeclarations import (
    check_class_element,
    check_component_element,
    inherited_class,
    same_class,
)
from acausal.lang.restrictions import check_base, check_class, check_combination

if TYPE_CHECKING:  # a scope has a table of elements, an element knows its scope
    from acausal.lang.scope import Scope


@light_object
class ComponentEntry:
    """A declared component: the class it was written in, and what modifies it.

    `through` holds the modifiers of `extends` clauses, outermost first; `below` those that its own modifiers
    override: of its constraining clause, and of the declaration it `replaces` by `redeclare`.
    """

    name: str
    clause: ast.ComponentClause
    declaration: ast.Declaration
    scope: Scope
    own: Modifier
    protected: bool
    through: tuple[Modifier, ...] = ()
    below: tuple[Modifier, ...] = ()
    replaces: ComponentEntry | None = None

    @property
    def written(self) -> Modifier:
        """What the declaration and the `extends` clauses on the way to it say."""
        whole = NO_MODIFIER
        for modifier in (*self.through, self.own):
            whole = merge(whole, modifier, self.name)
        return whole

    @property
    def constraint(self) -> Modifier:
        """What every redeclaration of this component keeps (7.3.2)."""
        kept = self.own if self.clause.constraint is None else NO_MODIFIER
        for modifier in self.below:
            kept = merge(kept, modifier, self.name)
        return kept


@dataclass(slots=True, eq=False)
class ClassEntry:
    """A nested class: its node, the scope it is nested in, the modifier that reaches it from outside.

    A redeclared class keeps the node of the original; the redeclaration is in `modifier`. `built` is the
    scope made from it.
    """

    name: str
    node: ClassNode
    scope: Scope
    modifier: Modifier = NO_MODIFIER
    built: Scope | None = None
    busy: bool = False
    """While the scope of a redeclared class is being built, to notice circles."""


@light_object
class Base:
    """One `extends` (or the right side of a short class): the base, its modification, where it is written.

    `dimensions` are those of a short class, to be evaluated in `where`.
    """

    scope: Scope
    modifier: Modifier
    dimensions: ast.Subscripts | None
    where: Scope
    span: Span


MAX_SECTIONS = 20_000
"""Equation and algorithm sections that a class may have, inherited ones included."""

Section = ast.EquationSection | ast.AlgorithmSection


@dataclass(slots=True, eq=False)
class Table:
    """What a class contains, inherited elements included, in order of declaration.

    `lineage` holds the class and everything it inherits from.
    """

    lineage: set[ClassNode]
    components: dict[str, ComponentEntry] = field(default_factory=dict[str, ComponentEntry])
    classes: dict[str, ClassEntry] = field(default_factory=dict[str, ClassEntry])
    sections: list[tuple[Section, Scope]] = field(default_factory=list[tuple[Section, "Scope"]])
    bases: list[Base] = field(default_factory=list[Base])
    external: ast.External | None = None
    hidden: set[str] = field(default_factory=set[str])
    """Names of classes that a protected `extends` inherits."""
    missing: set[str] = field(default_factory=set[str])
    """Names of classes that were looked for and are not there."""
    declaration_order: list[ComponentEntry] | None = None
    """Of a function: its variables, each behind those its declaration names, once it was called."""
    closed: bool | None = None
    """Whether it is or extends a simple type, an array class or one with a prefix, once that is known."""


def build_table(scope: Scope) -> Table:
    """The table of a class. Raises `LookupProblem`, `TypeProblem`."""
    definition = scope.definition
    if scope.root.is_first(scope.node):
        check_class(scope)
    table = Table({scope.node})
    if isinstance(definition, ast.ShortClass):
        where = scope.enclosing or scope
        base = scope.base_class(definition.base)
        own = merge(modifier_of(definition.modification, Context(where, None)), scope.below)
        _inherit(scope, table, Base(base, own, definition.dimensions, where, definition.span), False)
    elif isinstance(definition, ast.DerClass):
        where = scope.enclosing or scope
        base = where.find_class(definition.base)
        _inherit(scope, table, Base(base, NO_MODIFIER, None, where, definition.span), False)
    elif isinstance(definition, ast.LongClass):
        if definition.extends:
            _inherit_replaced(scope, table, definition)
        _fill(scope, table, definition)
        check_combination(scope, table)
    return table


def _inherit_replaced(scope: Scope, table: Table, definition: ast.LongClass) -> None:
    """`redeclare model extends M`: the class of this name that is inherited is the base (7.3.1)."""
    if scope.replaced is None:
        raise class_extends(definition)
    static = modifier_of(definition.modification, Context(scope, None))
    _inherit(scope, table, Base(scope.replaced, static, None, scope, definition.span), False)


def _fill(scope: Scope, table: Table, definition: ast.LongClass) -> None:
    for element in definition.body.elements:
        if isinstance(element, ast.Extends):
            base = scope.base_class(element.type)
            check_not_replaceable(scope, element.type)
            static = modifier_of(element.modification, Context(scope, None))
            _inherit(scope, table, Base(base, static, None, scope, element.span), element.protected)
        elif isinstance(element, ast.ComponentClause):
            for declaration in element.declarations:
                _add_component(scope, table, _declared(scope, element, declaration))
        elif isinstance(element, ast.ClassDefinition):
            _add_class(scope, table, element)
    table.sections += [(section, scope) for section in definition.body.sections]
    table.external = definition.body.external or table.external
    _redeclare_classes(scope, table, definition)
    _check_redeclarations(scope, table)


def _declared(scope: Scope, clause: ast.ComponentClause, declaration: ast.Declaration) -> ComponentEntry:
    context = Context(scope, None)
    own = modifier_of(declaration.modification, context)
    below: tuple[Modifier, ...] = ()
    if clause.constraint is not None and clause.constraint.modification is not None:
        below = (modifier_of(clause.constraint.modification, context),)
    protected = clause.prefixes.protected
    return ComponentEntry(declaration.name, clause, declaration, scope, own, protected, (), below)


def _redeclares(element: ast.ClassDefinition) -> bool:
    """`redeclare ...`, and `model extends M`, which does so without saying."""
    return element.prefixes.redeclare or (isinstance(element, ast.LongClass) and element.extends)


def own_redeclarations(scope: Scope) -> Modifier:
    """`redeclare` classes of the class body, as a modifier on what it inherits."""
    definition = scope.definition
    if not isinstance(definition, ast.LongClass):
        return NO_MODIFIER
    context = Context(scope, None)
    children: dict[str, Modifier] = {}
    for element in definition.body.elements:
        if isinstance(element, ast.ClassDefinition) and _redeclares(element):
            replaceable = element.prefixes.replaceable
            redeclaration = redeclaration_of(element, context, element.span, replaceable)
            children[element.name] = Modifier(redeclaration=redeclaration)
    return Modifier(children=children) if children else NO_MODIFIER


# --------------------------------------------------------------------------- inheritance


def _inherit(scope: Scope, table: Table, written: Base, protected: bool) -> None:
    """Merge the base's table into the derived one, with the extends modification on what it names."""
    static = written.modifier
    outside = merge(scope.modifier, merge(own_redeclarations(scope), static))
    check_base(scope, written.scope, written.span)
    base = written.scope.modified(outside)
    table.bases.append(Base(base, static, written.dimensions, written.where, written.span))
    if base.is_predefined:
        return
    inherited = base.table
    table.lineage |= inherited.lineage
    if not is_simple(base):
        for name, child in static.children.items():
            if base.find_local(name) is None:
                raise unknown_target(name, base, child.span or written.span)
    for name, entry in inherited.components.items():
        _add_inherited(scope, table, entry, static.children.get(name), protected)
    for name, entry in inherited.classes.items():
        own = table.classes.setdefault(name, entry)
        if own.scope is scope and not same_class(own.node.definition, entry.node.definition):
            raise inherited_class(name, own.node.definition.span, entry.node.definition.span)
    table.hidden.update(inherited.classes if protected else inherited.hidden)
    table.sections += inherited.sections
    if len(table.sections) > MAX_SECTIONS:
        raise too_large(scope, MAX_SECTIONS, written.span)
    table.external = table.external or inherited.external


def too_large(scope: Scope, most: int, span: Span) -> AcausalError:
    """A class that inherits more sections than anybody writes, by inheriting the same ones many times."""
    message = f"`{scope.path}` inherits more than {most} equation and algorithm sections"
    hint = "does a class extend another one twice, and that one again?"
    return fail(TypeProblem, "extends.too-large", message, span, names=[scope.path], hint=hint)


def _add_inherited(
    scope: Scope, table: Table, entry: ComponentEntry, modifier: Modifier | None, protected: bool
) -> None:
    through = entry.through if modifier is None else (modifier, *entry.through)
    copy = ComponentEntry(
        entry.name,
        entry.clause,
        entry.declaration,
        entry.scope,
        entry.own,
        entry.protected or protected,
        through,
        entry.below,
        entry.replaces,
    )
    _add_component(scope, table, copy)


def is_simple(scope: Scope) -> bool:
    """Whether a class is a predefined type, an enumeration, or derived from one without components."""
    if scope.is_predefined or isinstance(scope.definition, ast.EnumerationClass):
        return True
    table = scope.table
    return len(table.bases) == 1 and not table.components and is_simple(table.bases[0].scope)


# --------------------------------------------------------------------------- elements


def _is_redeclare(entry: ComponentEntry, scope: Scope) -> bool:
    return entry.clause.prefixes.redeclare and entry.scope is scope


def _add_component(scope: Scope, table: Table, entry: ComponentEntry) -> None:
    old = table.components.get(entry.name)
    if old is None and entry.name not in table.classes:
        table.components[entry.name] = entry
    elif old is None:
        first = table.classes[entry.name].node.definition.span
        raise duplicate(entry.name, scope, entry.declaration.span, first)
    elif _is_redeclare(entry, scope) and old.scope is not scope:
        table.components[entry.name] = _replacing(old, entry)
    elif _is_redeclare(old, scope) and entry.scope is not scope:
        table.components[entry.name] = _replacing(entry, old)
    elif old.declaration is not entry.declaration and (
        old.scope is entry.scope or not _same_declaration(old, entry)
    ):
        raise duplicate(entry.name, scope, entry.declaration.span, old.declaration.span)


def _replacing(old: ComponentEntry, new: ComponentEntry) -> ComponentEntry:
    """The `redeclare` element `new` in place of the inherited `old`."""
    if not old.clause.prefixes.replaceable:
        raise not_replaceable(old.name, new.declaration.span, old.declaration.span)
    check_component_element(old, new)
    below = (*new.below, old.constraint)
    return ComponentEntry(
        new.name, new.clause, new.declaration, new.scope, new.own, new.protected, old.through, below, old
    )


def _same_declaration(a: ComponentEntry, b: ComponentEntry) -> bool:
    """Declared or inherited twice with the same contents, descriptions aside (7.1.2)."""
    first, second = a.declaration, b.declaration
    return (
        a.clause.type == b.clause.type
        and a.protected == b.protected
        and (a.clause.flow, a.clause.variability, a.clause.causality)
        == (b.clause.flow, b.clause.variability, b.clause.causality)
        and (first.dimensions, first.condition) == (second.dimensions, second.condition)
        and (first.modification == second.modification or same_contents(a.written, b.written))
    )


def _add_class(scope: Scope, table: Table, element: ast.ClassDefinition) -> None:
    node = scope.node.child(element.name)
    old = table.classes.get(element.name)
    component = table.components.get(element.name)
    if component is not None:
        raise duplicate(element.name, scope, element.span, component.declaration.span)
    if (old is not None and old.scope is scope) or node is None or node.definition is not element:
        raise duplicate(element.name, scope, element.span, old.node.definition.span if old else None)
    if _redeclares(element):
        return  # see _redeclare_classes
    if old is not None and not same_class(element, old.node.definition):
        raise inherited_class(element.name, element.span, old.node.definition.span)
    table.classes[element.name] = ClassEntry(element.name, node, scope, scope.modifier.child(element.name))


def _redeclare_classes(scope: Scope, table: Table, definition: ast.LongClass) -> None:
    """Put the inherited classes, which carry their redeclaration, in place of the `redeclare` elements."""
    for element in definition.body.elements:
        if not isinstance(element, ast.ClassDefinition) or not _redeclares(element):
            continue
        found = [base.scope.find_class_entry(element.name) for base in table.bases]
        entry = next((entry for entry in found if entry is not None), None)
        if entry is None:
            raise _nothing_inherited(element.name, element.span)
        if not entry.node.definition.prefixes.replaceable:
            raise not_replaceable(element.name, element.span, entry.node.definition.span)
        check_class_element(entry, element, entry.node.definition.prefixes.protected)
        table.classes[element.name] = entry


def _check_redeclarations(scope: Scope, table: Table) -> None:
    """A `redeclare` component needs something inherited to redeclare."""
    for entry in table.components.values():
        if _is_redeclare(entry, scope) and entry.replaces is None:
            raise _nothing_inherited(entry.name, entry.declaration.span)


def _nothing_inherited(name: str, span: Span) -> AcausalError:
    return fail(
        LookupProblem,
        "redeclare.nothing",
        f"`{name}` is declared `redeclare`, but no element of this name is inherited",
        span,
        names=[name],
        hint="check the name, or leave out `redeclare`",
    )
