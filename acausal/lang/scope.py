"""Classes as name lookup sees them (Modelica 3.6, 5.3).

A `Scope` is a class in its lexical surroundings together with the redeclarations that reach it from
outside (`Tank t(redeclare package Medium = Water)`). Without redeclarations there is exactly one scope per
class and enclosing scope, and its table of elements is computed once.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from acausal.errors import Span
from acausal.lang import ast
from acausal.lang.access import check_complete, check_import, check_inside, is_protected
from acausal.lang.class_table import ClassEntry, ComponentEntry, Table, build_table
from acausal.lang.imports import Imported
from acausal.lang.library import ClassNode, Library, name_parts
from acausal.lang.light import light_object
from acausal.lang.lookup_errors import (
    ambiguous_import,
    component_as_class,
    cyclic_extends,
    outer_class,
    unknown_import,
    unknown_name,
    unknown_nested,
)
from acausal.lang.modifiers import NO_MODIFIER, Modifier, Redeclaration, merge
from acausal.lang.predefined import PREDEFINED, PREDEFINED_FILE, predefined
from acausal.lang.redeclarations import kept_modifier, redeclared_class


@light_object
class FoundComponent:
    """A component that lookup found, and the class (package, usually) it was found in."""

    entry: ComponentEntry
    where: Scope


@dataclass
class Root:
    """The library and the scopes of its top-level classes."""

    library: Library
    scopes: dict[str, Scope] = field(default_factory=dict[str, "Scope"])
    _seen: set[ClassNode] = field(default_factory=set[ClassNode])

    def __post_init__(self) -> None:
        for name in PREDEFINED:
            self.scopes[name] = Scope(ClassNode(predefined(name), None, None), None, self)

    def top(self, name: str) -> Scope | None:
        """The scope of a predefined type or top-level class."""
        if name not in self.scopes:
            node = self.library.top_level(name)
            if node is None:
                return None
            self.scopes[name] = Scope(node, None, self)
        return self.scopes[name]

    def is_first(self, node: ClassNode) -> bool:
        """Whether this class is asked about for the first time: its text is checked once."""
        first = node not in self._seen
        self._seen.add(node)
        return first

    def find(self, dotted: str) -> Scope:
        """The scope of a class given by its full name."""
        self.library.find(dotted)
        first, *rest = name_parts(dotted)
        current = self.top(first)
        assert current is not None  # the library has found it
        for part in rest:
            current = current.find_nested(part, current.span)
        return current


class Scope:
    """A class in its surroundings; see the module's text. `enclosing` is None for a top-level class.

    `modifier` holds what outside modifications say about the classes inside; `below` the modifications that
    a redeclared class keeps from what it replaces, `constraints` the classes that it must be compatible with,
    and each with the next, and `replaced` the class that `redeclare model extends M` extends.
    """

    __slots__ = (
        "_busy",
        "_looked_up",
        "_modified",
        "_nested",
        "_table",
        "below",
        "constraints",
        "enclosing",
        "modifier",
        "node",
        "replaced",
        "root",
    )

    def __init__(
        self,
        node: ClassNode,
        enclosing: Scope | None,
        root: Root,
        modifier: Modifier = NO_MODIFIER,
        below: Modifier = NO_MODIFIER,
        constraints: tuple[Scope, ...] = (),
        replaced: Scope | None = None,
    ) -> None:
        self.node = node
        self.enclosing = enclosing
        self.root = root
        self.modifier = modifier
        self.below = below
        self.constraints = constraints
        self.replaced = replaced
        self._table: Table | None = None
        self._busy = False
        self._looked_up: dict[str, Found | None] = {}
        self._nested: dict[str, Scope] = {}
        self._modified: dict[tuple[tuple[str, Modifier], ...], Scope] = {}

    @property
    def definition(self) -> ast.ClassDefinition:
        return self.node.definition

    @property
    def path(self) -> str:
        return self.node.path

    @property
    def kind(self) -> ast.ClassKind:
        return self.node.definition.kind

    @property
    def span(self) -> Span:
        return self.node.definition.span

    @property
    def is_predefined(self) -> bool:
        return self.enclosing is None and self.node.definition.span.file == PREDEFINED_FILE

    @property
    def table(self) -> Table:
        """Own and inherited elements. Raises `LookupProblem` `extends.cyclic`."""
        if self._table is None:
            if self._busy:
                raise cyclic_extends(self)
            self._busy = True
            try:
                self._table = build_table(self)
            finally:
                self._busy = False
        return self._table

    @property
    def known_table(self) -> Table | None:
        """The table, unless the bases of this class are being resolved just now."""
        return None if self._table is None and self._busy else self.table

    # ------------------------------------------------------------------ other scopes

    def nested(self, entry: ClassEntry) -> Scope:
        """The scope of a nested class of this scope's table."""
        if entry.built is None:
            if entry.node.definition.prefixes.outer:
                raise outer_class(entry.name, entry.node.definition.span)
            if entry.modifier is NO_MODIFIER:
                entry.built = entry.scope.plain_nested(entry)
            else:
                entry.built = _modified_class(entry, self.root)
        return entry.built

    def plain_nested(self, entry: ClassEntry) -> Scope:
        """The one scope of a nested class that nothing modifies from outside."""
        found = self._nested.get(entry.name)
        if found is None or found.node is not entry.node:
            below = kept_modifier(entry) if entry.node.definition.constraint is not None else NO_MODIFIER
            found = self._nested[entry.name] = Scope(entry.node, self, self.root, NO_MODIFIER, below)
        return found

    def modified(self, modifier: Modifier) -> Scope:
        """The same class with redeclarations of its classes from outside; itself when there are none.

        Of a package also its constants count: the classes inside use them.
        """
        if not modifier.children or self.is_predefined:
            return self
        relevant = modifier.children
        if self.kind != "package":
            relevant = {name: child for name, child in relevant.items() if self._is_class(name, child)}
        if not relevant:
            return self
        key = tuple(relevant.items())
        if key not in self._modified:
            outside = merge(Modifier(children=relevant), self.modifier)
            self._modified[key] = Scope(
                self.node, self.enclosing, self.root, outside, self.below, self.constraints, self.replaced
            )
        return self._modified[key]

    def _is_class(self, name: str, child: Modifier) -> bool:
        """Whether a modifier addresses a class (not a component) of this one."""
        if child.redeclaration is not None and child.redeclaration.node is not None:
            return True
        return name not in self.table.components and self.find_class_entry(name) is not None

    # ------------------------------------------------------------------ lookup

    def element_names(self) -> list[str]:
        """Names of all elements, for suggestions; nothing while the bases are being resolved."""
        if self._table is None:
            return []
        return [*self._table.components, *self._table.classes]

    def find_local(self, name: str) -> ComponentEntry | ClassEntry | None:
        """The element `name` of this class, inherited ones included."""
        if not self._busy or self._table is not None:
            found = self.table.components.get(name)
            if found is not None:
                return found
        return self.find_class_entry(name)

    def find_class_entry(self, name: str) -> ClassEntry | None:
        """The nested class `name`. While the bases of this class are being resolved: own ones only."""
        if self._table is None and self._busy:
            child = self.node.child(name)
            return None if child is None else ClassEntry(name, child, self, self.modifier.child(name))
        table = self.table
        found = table.classes.get(name)
        if found is None and name not in table.missing and name not in table.components:
            found = self._stored_class(name, table)
        return found

    def _stored_class(self, name: str, table: Table) -> ClassEntry | None:
        """A class in a file of its own, of this package or of one it inherits from; read now and kept."""
        child = self.node.child(name)
        entry: ClassEntry | None = None
        if child is not None:
            entry = ClassEntry(name, child, self, self.modifier.child(name))
        else:
            for base in table.bases:
                entry = None if base.scope.is_predefined else base.scope.find_class_entry(name)
                if entry is not None:
                    break
        if entry is None:
            table.missing.add(name)
        else:
            table.classes[name] = entry
        return entry

    def find(self, name: str) -> Found | None:
        """Look a simple name up here, in the imports, in the enclosing classes, then at the top level."""
        if name in self._looked_up:
            return self._looked_up[name]
        found = self._look_up(name)
        scope: Scope | None = self
        while scope is not None and scope._table is not None and not scope._busy:
            scope = scope.enclosing
        if scope is None:  # else it may look different when the bases are known
            self._looked_up[name] = found
        return found

    def _look_up(self, name: str) -> Found | None:
        scope: Scope | None = self
        while scope is not None:
            entry = scope.find_local(name)
            if entry is not None:
                return _found(entry, scope)
            imported = _find_import(scope, name)
            if imported is not None:
                return imported
            if scope.definition.class_prefixes.encapsulated:
                return self.root.top(name) if name in PREDEFINED else None
            scope = scope.enclosing
        return self.root.top(name)

    def find_class(
        self, reference: ast.ComponentReference, what: str = "class", complete: bool = False
    ) -> Scope:
        """The class (or function) a dotted name refers to. Raises `LookupProblem`.

        `complete` says that it is used in the model that is built: classes looked into must not be partial.
        """
        first = reference.parts[0].name
        found = self.root.top(first) if reference.global_ else self.find(first)
        if found is None:
            raise unknown_name(first, self, reference.span, what)
        if isinstance(found, FoundComponent):
            raise component_as_class(first, found.entry.declaration.span, reference.span)
        current = found
        for part in reference.parts[1:]:
            if complete:
                check_complete(current, part.name, part.span)
            current = current.find_inside(part.name, part.span)
        return current

    def base_class(self, reference: ast.ComponentReference) -> Scope:
        """The class that an `extends` clause or the right side of a short class names.

        That of a short class is looked up around the class, so that `model M = M` finds another `M`.
        """
        if not isinstance(self.definition, ast.ShortClass):
            return self.find_class(reference)
        if self.enclosing is not None:
            return self.enclosing.find_class(reference)
        found = self.root.top(reference.parts[0].name)
        if found is None:
            raise unknown_name(reference.parts[0].name, self, reference.span, "class")
        for part in reference.parts[1:]:
            found = found.find_inside(part.name, part.span)
        return found

    def find_nested(self, name: str, span: Span) -> Scope:
        """The class `name` in this class. Raises `LookupProblem` `lookup.unknown-class`."""
        entry = self.find_class_entry(name)
        if entry is None:
            raise unknown_nested(name, self, span)
        return self.nested(entry)

    def find_inside(self, name: str, span: Span) -> Scope:
        """As `find_nested`, for dot notation in a text. Raises `lookup.protected`, `lookup.not-package`."""
        found = self.find_nested(name, span)
        entry = self.find_class_entry(name)
        if entry is not None:
            check_inside(self, entry, span)
        return found


Found = FoundComponent | Scope


def _found(entry: ComponentEntry | ClassEntry, where: Scope) -> Found:
    return where.nested(entry) if isinstance(entry, ClassEntry) else FoundComponent(entry, where)


def _modified_class(entry: ClassEntry, root: Root) -> Scope:
    """A nested class that is redeclared or modified from outside."""
    found = redeclared_class(entry)
    redeclaration = entry.modifier.redeclaration
    replaced = None
    if redeclaration is not None and redeclaration.extends:
        replaced = _replaced(entry, redeclaration.over, root)
    return Scope(found.node, found.enclosing, root, found.modifier, found.below, found.constraints, replaced)


def _replaced(entry: ClassEntry, over: Redeclaration | None, root: Root) -> Scope:
    """The class that `redeclare model extends M` extends: `M` as it would be without it."""
    if over is None:
        return entry.scope.plain_nested(entry)
    below = ClassEntry(entry.name, entry.node, entry.scope, Modifier(redeclaration=over))
    return _modified_class(below, root)


# --------------------------------------------------------------------------- imports


def _find_import(scope: Scope, name: str) -> Found | None:
    """What the class's imports say of a name. Raises `import.ambiguous`."""
    imports = scope.node.imports
    named = imports.named.get(name)
    if named is not None:
        return _imported(scope.root, named)
    found: Found | None = None
    for clause in imports.wildcards:
        package = _imported(scope.root, Imported(clause.name, clause))
        entry = package.find_local(name) if isinstance(package, Scope) else None
        if entry is None or not isinstance(package, Scope) or is_protected(package, entry):
            continue
        check_import(package, f"{package.path}.{name}", clause.span)
        other = _found(entry, package)
        if found is not None and not _same(found, other):
            raise ambiguous_import(name, clause.span)
        found = other
    return found


def _same(a: Found, b: Found) -> bool:
    if isinstance(a, FoundComponent) and isinstance(b, FoundComponent):
        return a.entry.declaration is b.entry.declaration
    return isinstance(a, Scope) and isinstance(b, Scope) and a.node is b.node


def _imported(root: Root, imported: Imported) -> Found:
    first, *rest = imported.target
    current = root.top(first)
    shown = ".".join(imported.target)
    if current is None:
        raise unknown_import(shown, root.library.top_level_names(), imported.clause.span)
    for i, part in enumerate(rest, start=1):
        found = current.find_local(part)
        if i == len(rest) and not imported.clause.wildcard:
            check_import(current, shown, imported.clause.span)
        if isinstance(found, ComponentEntry) and i == len(rest):
            check_inside(current, found, imported.clause.span)
            return FoundComponent(found, current)
        current = current.find_inside(part, imported.clause.span)
    return current
