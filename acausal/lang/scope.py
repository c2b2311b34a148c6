"""Classes as name lookup sees them: own and inherited elements, redeclarations applied.

A `Scope` is a class in its lexical surroundings together with the redeclarations that reach it from
outside (`Tank t(redeclare package Medium = Water)`). Without redeclarations there is exactly one scope per
class and enclosing scope, and its table of elements is computed once.

Lookup rules: Modelica 3.6, 5.3. Inherited elements become part of the derived class (7.1).
"""

from __future__ import annotations

from dataclasses import dataclass, field
from difflib import get_close_matches

from acausal.errors import LookupProblem, Source, Span, fail
from acausal.lang import ast
from acausal.lang.library import ClassNode, Library
from acausal.lang.modifiers import NO_MODIFIER, Context, Modifier, merge

_PREDEFINED_ENUMERATIONS: dict[str, tuple[str, ...]] = {
    "StateSelect": ("never", "avoid", "default", "prefer", "always"),
    "AssertionLevel": ("warning", "error"),
}
_PREDEFINED_FILE = "<predefined>"
SIMPLE_TYPES = ("Real", "Integer", "Boolean", "String")
EXTERNAL_OBJECT = "ExternalObject"


@dataclass(slots=True)
class ComponentEntry:
    """A declared component: the class it was written in, and the arguments of `extends` clauses that modify it.

    `through` holds (arguments, class of the extends clause), outermost first.
    """

    name: str
    clause: ast.ComponentClause
    declaration: ast.Declaration
    scope: Scope
    through: tuple[tuple[tuple[ast.Argument, ...], Scope], ...] = ()
    protected: bool = False


@dataclass(slots=True)
class ClassEntry:
    """A nested class: its node, the scope it is nested in, the modifier that reaches it from outside."""

    name: str
    node: ClassNode
    scope: Scope
    modifier: Modifier = NO_MODIFIER


@dataclass(slots=True)
class FoundComponent:
    """A component that lookup found, and the class (package, usually) it was found in."""

    entry: ComponentEntry
    where: Scope


Entry = ComponentEntry | ClassEntry
Section = ast.EquationSection | ast.AlgorithmSection


@dataclass(slots=True)
class Table:
    """What a class contains, inherited elements included, in order of declaration."""

    components: dict[str, ComponentEntry] = field(default_factory=lambda: {})
    classes: dict[str, ClassEntry] = field(default_factory=lambda: {})
    sections: list[tuple[Section, Scope]] = field(default_factory=lambda: [])
    bases: list[Base] = field(default_factory=lambda: [])
    external: ast.External | None = None


@dataclass(slots=True)
class Base:
    """One `extends` (or the right side of a short class): the base, its modification, where it is written."""

    scope: Scope
    modification: ast.Modification | None
    dimensions: ast.Subscripts | None
    protected: bool
    span: Span


@dataclass
class Root:
    """The library and the scopes of its top-level classes."""

    library: Library
    scopes: dict[str, Scope] = field(default_factory=lambda: {})

    def __post_init__(self) -> None:
        for name in (*SIMPLE_TYPES, *_PREDEFINED_ENUMERATIONS, EXTERNAL_OBJECT):
            self.scopes[name] = Scope(ClassNode(_predefined(name), None, None), None, self)

    def top(self, name: str) -> Scope | None:
        """The scope of a predefined type or top-level class."""
        if name not in self.scopes:
            node = self.library.top_level(name)
            if node is None:
                return None
            self.scopes[name] = Scope(node, None, self)
        return self.scopes[name]

    def find(self, dotted: str) -> Scope:
        """The scope of a class given by its full name."""
        self.library.find(dotted)
        parts = dotted.split(".")
        current = self.top(parts[0])
        assert current is not None
        for part in parts[1:]:
            entry = current.find_class_entry(part)
            assert entry is not None
            current = current.nested(entry)
        return current


def _predefined(name: str) -> ast.ClassDefinition:
    """The definition of a predefined type, which has no text."""
    span = Span(Source(_PREDEFINED_FILE, name), 0, len(name))
    no_comment = ast.Comment(None, None)
    plain = (ast.ClassPrefixes(), ast.Prefixes())
    literals = _PREDEFINED_ENUMERATIONS.get(name)
    if literals is not None:
        entries = tuple([ast.EnumerationLiteral(literal, no_comment, span) for literal in literals])
        return ast.EnumerationClass(name, "type", *plain, entries, no_comment, None, span)
    body = ast.Composition((), (), None, None)
    return ast.LongClass(name, "class" if name == EXTERNAL_OBJECT else "type", *plain, False, None, None, body, None, span)


class Scope:
    """A class in its surroundings; see the module's text. `enclosing` is None for a top-level class."""

    __slots__ = ("_busy", "_nested", "_table", "enclosing", "modifier", "node", "root")

    def __init__(
        self, node: ClassNode, enclosing: Scope | None, root: Root, modifier: Modifier = NO_MODIFIER
    ) -> None:
        self.node = node
        self.enclosing = enclosing
        self.root = root
        self.modifier = modifier
        self._table: Table | None = None
        self._busy = False
        self._nested: dict[str, Scope] = {}

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
        return self.enclosing is None and self.span.file == _PREDEFINED_FILE

    @property
    def table(self) -> Table:
        """Own and inherited elements. Raises `LookupProblem` `extends.cyclic`."""
        if self._table is None:
            if self._busy:
                raise _cyclic(self)
            self._busy = True
            try:
                self._table = _build_table(self)
            finally:
                self._busy = False
        return self._table

    # ------------------------------------------------------------------ nested scopes

    def nested(self, entry: ClassEntry) -> Scope:
        """The scope of a nested class of this scope's table."""
        if entry.modifier is NO_MODIFIER:
            cache = entry.scope._nested
            found = cache.get(entry.name)
            if found is None or found.node is not entry.node:
                found = cache[entry.name] = Scope(entry.node, entry.scope, self.root)
            return found
        return _modified_class(entry, self.root)

    def modified(self, modifier: Modifier) -> Scope:
        """The same class with redeclarations of its classes from outside; itself when there are none."""
        relevant = _class_part(modifier, self)
        if relevant is NO_MODIFIER:
            return self
        return Scope(self.node, self.enclosing, self.root, merge(relevant, self.modifier))

    # ------------------------------------------------------------------ lookup

    def element_names(self) -> list[str]:
        """Names of all elements, for suggestions; nothing while the bases are being resolved."""
        if self._table is None and self._busy:
            return []
        return [*self.table.components, *self.table.classes]

    def find_local(self, name: str) -> Entry | None:
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
            return None if child is None else ClassEntry(name, child, self)
        table = self.table
        found = table.classes.get(name)
        if found is None and name not in table.components:
            found = _stored_class(self, name, table)
        return found

    def find(self, name: str) -> Found | None:
        """Look a simple name up here, in the imports, then in the enclosing classes, then at the top level."""
        scope: Scope | None = self
        while scope is not None:
            entry = scope.find_local(name)
            if entry is not None:
                return _found(entry, scope)
            imported = _find_import(scope, name)
            if imported is not None:
                return imported
            if scope.definition.class_prefixes.encapsulated:
                break
            scope = scope.enclosing
        return self.root.top(name)

    def find_class(self, reference: ast.ComponentReference) -> Scope:
        """The class a (dotted) type name refers to. Raises `LookupProblem`."""
        first = reference.parts[0].name
        found = self.root.top(first) if reference.global_ else self.find(first)
        if found is None:
            raise unknown_name(first, self, reference.span, "class")
        if isinstance(found, FoundComponent):
            raise fail(
                LookupProblem,
                "lookup.not-a-class",
                f"`{first}` is a component, but a class is needed here",
                reference.span,
                names=[first],
                hint=f"`{first}` is declared at {found.entry.declaration.span}",
            )
        current = found
        for part in reference.parts[1:]:
            current = current.find_nested(part.name, part.span)
        return current

    def find_nested(self, name: str, span: Span) -> Scope:
        """The class `name` in this class. Raises `LookupProblem` `lookup.unknown-class`."""
        entry = self.find_class_entry(name)
        if entry is None:
            known = [*self.table.classes, *self.node.child_names()]
            near = get_close_matches(name, known, 3)
            raise fail(
                LookupProblem,
                "lookup.unknown-class",
                f"class `{name}` is not found in `{self.path}`",
                span,
                names=[f"{self.path}.{name}"],
                hint=did_you_mean(near) or f"`{self.path}` has no such class",
            )
        return self.nested(entry)


Found = FoundComponent | Scope


def _found(entry: Entry, where: Scope) -> Found:
    return where.nested(entry) if isinstance(entry, ClassEntry) else FoundComponent(entry, where)


# --------------------------------------------------------------------------- building the table


def _build_table(scope: Scope) -> Table:
    definition = scope.definition
    table = Table()
    if isinstance(definition, ast.ShortClass):
        base = scope_of_type(scope.enclosing, definition.base, scope.root)
        _inherit(scope, table, base, definition.modification, definition.dimensions, False, definition.span)
    elif isinstance(definition, ast.LongClass):
        if definition.extends:
            raise _class_extends(definition)
        _fill_long_class(scope, table, definition)
    return table


def _fill_long_class(scope: Scope, table: Table, definition: ast.LongClass) -> None:
    for element in definition.body.elements:
        if isinstance(element, ast.Extends):
            base = scope.find_class(element.type)
            _inherit(scope, table, base, element.modification, None, element.protected, element.span)
        elif isinstance(element, ast.ComponentClause):
            for declaration in element.declarations:
                entry = ComponentEntry(
                    declaration.name, element, declaration, scope, protected=element.prefixes.protected
                )
                _add_component(scope, table, entry)
        elif isinstance(element, ast.ClassDefinition):
            _add_class(scope, table, element)
    table.sections += [(section, scope) for section in definition.body.sections]
    table.external = definition.body.external or table.external


def scope_of_type(enclosing: Scope | None, reference: ast.ComponentReference, root: Root) -> Scope:
    """Look a type name up from `enclosing` (None: from the top level)."""
    if enclosing is not None:
        return enclosing.find_class(reference)
    current = root.top(reference.parts[0].name)
    if current is None:
        known = root.library.top_level_names()
        raise fail(
            LookupProblem,
            "lookup.unknown-class",
            f"class `{reference.text}` is not found",
            reference.span,
            names=[reference.text],
            hint=did_you_mean(get_close_matches(reference.parts[0].name, known, 3)) or "check the library path",
        )
    for part in reference.parts[1:]:
        current = current.find_nested(part.name, part.span)
    return current


def _inherit(
    scope: Scope,
    table: Table,
    base: Scope,
    modification: ast.Modification | None,
    dimensions: ast.Subscripts | None,
    protected: bool,
    span: Span,
) -> None:
    """Merge the base's table into the derived one, with the extends modification on every element it names."""
    from acausal.lang.modifiers import arguments_for, modifier_of

    static = modifier_of(modification, Context(scope, None))
    own = _own_redeclarations(scope)
    base = base.modified(merge(scope.modifier, merge(own, static)))
    table.bases.append(Base(base, modification, dimensions, protected, span))
    if base.is_predefined:
        return
    inherited = base.table
    grouped = arguments_for(modification)
    if not is_simple(base):
        _check_targets(grouped, base)
    for name, entry in inherited.components.items():
        arguments = grouped.get(name)
        through = entry.through if arguments is None else ((tuple(arguments), scope), *entry.through)
        copy = ComponentEntry(
            name, entry.clause, entry.declaration, entry.scope, through, entry.protected or protected
        )
        _add_component(scope, table, copy)
    for name, entry in inherited.classes.items():
        if name not in table.classes:
            table.classes[name] = entry
    table.sections += inherited.sections
    table.external = table.external or inherited.external


def _own_redeclarations(scope: Scope) -> Modifier:
    """`redeclare` elements of the class body, as a modifier on what it inherits."""
    from acausal.lang.modifiers import Redeclaration

    definition = scope.definition
    if not isinstance(definition, ast.LongClass):
        return NO_MODIFIER
    context = Context(scope, None)
    children: dict[str, Modifier] = {}
    for element in definition.body.elements:
        if isinstance(element, ast.ClassDefinition) and element.prefixes.redeclare:
            if isinstance(element, ast.LongClass) and element.extends:
                raise _class_extends(element)
            children[element.name] = Modifier(redeclaration=Redeclaration(element, context, element.span))
    return Modifier(children=children) if children else NO_MODIFIER


def is_simple(scope: Scope) -> bool:
    """Whether a class is a predefined type, an enumeration, or derived from one without components."""
    if scope.is_predefined or isinstance(scope.definition, ast.EnumerationClass):
        return True
    table = scope.table
    return len(table.bases) == 1 and not table.components and is_simple(table.bases[0].scope)


def _check_targets(grouped: dict[str, list[ast.Argument]], base: Scope) -> None:
    for name, arguments in grouped.items():
        if base.find_local(name) is None:
            raise unknown_target(name, base, arguments[0].span)


def unknown_target(name: str, target: Scope, span: Span) -> LookupProblem:
    """The error for a modification of an element that the class does not have."""
    near = get_close_matches(name, [*target.table.components, *target.table.classes], 3)
    error = fail(
        LookupProblem,
        "lookup.unknown-modified-element",
        f"`{target.path}` has no element `{name}` to modify",
        span,
        names=[name],
        hint=did_you_mean(near) or f"see the declaration of `{target.path}` at {target.span}",
    )
    assert isinstance(error, LookupProblem)
    return error


def _add_component(scope: Scope, table: Table, entry: ComponentEntry) -> None:
    old = table.components.get(entry.name)
    if old is None and entry.name not in table.classes:
        table.components[entry.name] = entry
        return
    if old is not None and entry.clause.prefixes.redeclare and entry.scope is scope:
        table.components[entry.name] = entry
        return
    if old is not None and old.declaration is entry.declaration and old.scope is entry.scope:
        return
    if old is not None and old.scope is not entry.scope and _same_declaration(old, entry):
        return
    raise _duplicate(entry.name, scope, entry.declaration.span, old.declaration.span if old else None)


def _same_declaration(a: ComponentEntry, b: ComponentEntry) -> bool:
    """Inherited twice with identical text (7.1.2)."""
    return a.declaration == b.declaration and a.clause.type == b.clause.type


def _add_class(scope: Scope, table: Table, element: ast.ClassDefinition) -> None:
    node = scope.node.child(element.name)
    assert node is not None
    old = table.classes.get(element.name)
    if (old is not None and old.scope is scope) or element.name in table.components or node.definition is not element:
        raise _duplicate(element.name, scope, element.span, old.node.definition.span if old else None)
    table.classes[element.name] = ClassEntry(element.name, node, scope, scope.modifier.child(element.name))


def _stored_class(scope: Scope, name: str, table: Table) -> ClassEntry | None:
    """A class in a file of its own, of this package or of one it inherits from; read now and kept."""
    child = scope.node.child(name)
    entry: ClassEntry | None = None
    if child is not None:
        entry = ClassEntry(name, child, scope, scope.modifier.child(name))
    else:
        for base in table.bases:
            entry = None if base.scope.is_predefined else base.scope.find_class_entry(name)
            if entry is not None:
                break
    if entry is not None:
        table.classes[name] = entry
    return entry


def _class_part(modifier: Modifier, scope: Scope) -> Modifier:
    """The children of a modifier that address classes of `scope`."""
    if not modifier.children or scope.is_predefined:
        return NO_MODIFIER
    children = {
        name: child
        for name, child in modifier.children.items()
        if (child.redeclaration is not None and isinstance(child.redeclaration.element, ast.ClassDefinition))
        or (name not in scope.table.components and scope.find_class_entry(name) is not None)
    }
    return Modifier(children=children) if children else NO_MODIFIER


def _modified_class(entry: ClassEntry, root: Root) -> Scope:
    """A nested class that is redeclared or modified from outside."""
    modifier = entry.modifier
    if modifier.redeclaration is None:
        return Scope(entry.node, entry.scope, root, modifier)
    element = modifier.redeclaration.element
    if not isinstance(element, ast.ClassDefinition):
        raise fail(
            LookupProblem,
            "redeclare.kind",
            f"`{entry.name}` is a class, but it is redeclared as a component",
            modifier.redeclaration.span,
            names=[entry.name],
        )
    where = modifier.redeclaration.context.scope
    rest = Modifier(children=modifier.children) if modifier.children else NO_MODIFIER
    return Scope(ClassNode(element, where.node, None), where, root, rest)


# --------------------------------------------------------------------------- imports


def _find_import(scope: Scope, name: str) -> Found | None:
    definition = scope.definition
    if not isinstance(definition, ast.LongClass):
        return None
    for element in definition.body.elements:
        if not isinstance(element, ast.Import):
            continue
        target = _import_target(element, name)
        if target is not None:
            return _imported(scope.root, target, element)
    for element in definition.body.elements:
        if isinstance(element, ast.Import) and element.wildcard:
            package = _imported(scope.root, element.name, element)
            entry = package.find_local(name) if isinstance(package, Scope) else None
            if entry is not None and isinstance(package, Scope):
                return _found(entry, package)
    return None


def _import_target(element: ast.Import, name: str) -> tuple[str, ...] | None:
    if element.wildcard:
        return None
    if element.group:
        return (*element.name, name) if name in element.group else None
    shown = element.alias if element.alias is not None else element.name[-1]
    return element.name if shown == name else None


def _imported(root: Root, target: tuple[str, ...], element: ast.Import) -> Found:
    current = root.top(target[0])
    if current is None:
        near = get_close_matches(target[0], root.library.top_level_names(), 3)
        raise fail(
            LookupProblem,
            "lookup.unknown-import",
            f"imported `{'.'.join(target)}` is not found: there is no `{target[0]}` on the library path",
            element.span,
            names=[".".join(target)],
            hint=did_you_mean(near) or "imports start at the top level; check --path and MODELICAPATH",
        )
    for i, part in enumerate(target[1:], start=1):
        found = current.find_local(part)
        if isinstance(found, ComponentEntry) and i == len(target) - 1:
            return FoundComponent(found, current)
        current = current.find_nested(part, element.span)
    return current


# --------------------------------------------------------------------------- messages


def did_you_mean(near: list[str]) -> str:
    """`did you mean `a` or `b`?`, or nothing."""
    unique = list(dict.fromkeys(near))
    return f"did you mean {' or '.join(f'`{n}`' for n in unique)}?" if unique else ""


def unknown_name(name: str, scope: Scope, span: Span, what: str = "name") -> LookupProblem:
    """The error for a simple name that no lookup rule finds, with near misses from every surrounding class."""
    known: list[str] = []
    current: Scope | None = scope
    while current is not None:
        known += [*current.element_names(), *current.node.child_names()]
        current = current.enclosing
    known += [*scope.root.library.top_level_names(), *SIMPLE_TYPES]
    error = fail(
        LookupProblem,
        f"lookup.unknown-{what}",
        f"{what} `{name}` is not found in `{scope.path}`, around it, or on the library path",
        span,
        names=[name],
        hint=did_you_mean(get_close_matches(name, known, 3)) or f"declare `{name}` or import it",
    )
    assert isinstance(error, LookupProblem)
    return error


def _cyclic(scope: Scope) -> LookupProblem:
    error = fail(
        LookupProblem,
        "extends.cyclic",
        f"the class `{scope.path}` extends itself, directly or through another class",
        scope.span,
        names=[scope.path],
        hint="break the circle of `extends`",
    )
    assert isinstance(error, LookupProblem)
    return error


def _class_extends(definition: ast.LongClass) -> LookupProblem:
    from acausal.errors import UnsupportedProblem

    raise fail(
        UnsupportedProblem,
        "unsupported.class-extends",
        f"`{definition.kind} extends {definition.name}` is not supported yet",
        definition.span,
        names=[definition.name],
        hint="extend the inherited class under a new name",
    )


def _duplicate(name: str, scope: Scope, span: Span, first: Span | None) -> LookupProblem:
    error = fail(
        LookupProblem,
        "lookup.duplicate-element",
        f"`{name}` is declared twice in `{scope.path}`",
        span,
        names=[name],
        hint=f"the first declaration is at {first}" if first else "rename one of them",
    )
    assert isinstance(error, LookupProblem)
    return error
