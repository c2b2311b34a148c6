"""From a class to its instance tree: modifiers merged, types found, sizes and conditions decided.

Members are built when they are first asked for, because a size may depend on a parameter declared later;
`complete` asks for all of them in the end.
"""

from __future__ import annotations

from dataclasses import replace

from acausal.errors import TypeProblem, fail
from acausal.lang import ast
from acausal.lang.array_sizes import array_shape
from acausal.lang.class_table import ComponentEntry
from acausal.lang.compatibility import (
    check_component_declaration,
    check_component_redeclaration,
)
from acausal.lang.component_plan import Plan, array_of, check_targets, description_of, spread_record
from acausal.lang.component_prefixes import (
    component_prefixes,
    discrete_default,
    inherit_kind,
    with_causality,
)
from acausal.lang.flat import Causality
from acausal.lang.inner_components import Inners, check_unmodified, no_outer_around
from acausal.lang.instance import Absent, Array, Connection, Instance, Leaf, Member, Outer, Prefixes
from acausal.lang.instance_errors import (
    check_instantiable,
    cyclic_structure,
    modifies_protected,
    not_a_component,
    too_deep,
    too_large,
)
from acausal.lang.modifiers import (
    NO_MODIFIER,
    Binding,
    Context,
    Modifier,
    bound,
    merge,
    modifier_of,
    not_replaceable,
    overrides_final,
)
from acausal.lang.overdetermined import Overdetermined
from acausal.lang.redeclarations import check_not_constant, constraints_of, redeclared_modifier
from acausal.lang.restrictions_functions import check_used
from acausal.lang.scope import Scope
from acausal.lang.simple_types import SimpleType, SimpleTypes, with_attributes
from acausal.lang.size_bound import MAX_MEMBERS, SizeBound
from acausal.lang.stream_flows import check_stream
from acausal.lang.translation import Translation

MAX_DEPTH = 100
"""Components nested deeper than this are taken for a model that contains itself."""


class Instantiator:
    """Builds members on demand."""

    def __init__(self, translation: Translation) -> None:
        self._translation = translation
        self._types = SimpleTypes()
        self._packages: dict[Scope, Instance] = {}
        self._building: dict[tuple[Instance, str], list[int]] = {}
        self._checked: set[Scope] = set()
        self._type_scopes: dict[ComponentEntry, Scope] = {}
        self._prefixes: dict[tuple[ComponentEntry, Prefixes], Prefixes] = {}
        self._attributes: dict[tuple[SimpleType, tuple[Modifier, ...]], dict[str, Binding]] = {}
        self._count = 0
        self._inners = Inners(self, translation, self._types)
        self.has_expandable = False
        """Whether any component is an expandable connector."""
        self.has_streams = False
        """Whether any variable is a stream variable."""
        self._overdetermined = Overdetermined()

    # ------------------------------------------------------------------ roots

    def model(self, scope: Scope, modifier: Modifier) -> Instance:
        """The top-level instance; its path is empty."""
        scope = scope.modified(modifier)
        check_targets(scope, modifier)
        return Instance("", scope, None, Prefixes(), scope.span, description_of(scope), modifier)

    def package(self, scope: Scope) -> Instance:
        """The instance that holds a package's (or class's) constants."""
        found = self._packages.get(scope)
        if found is None:
            self.check_redeclared(scope)
            modifier = scope.modifier
            found = Instance(scope.path, scope, None, Prefixes(), scope.span, "", modifier, {}, True)
            self._packages[scope] = found
        return found

    def complete(self, root: Instance) -> Instance:
        """Build every member below `root`."""
        stack: list[tuple[Member | Outer, int]] = [(root, 0)]
        bound = SizeBound(self._types)
        while stack:
            bound.look_ahead(self._count, stack)
            member, depth = stack.pop()
            if isinstance(member, Instance):
                if depth > MAX_DEPTH:
                    raise too_deep(member, MAX_DEPTH)
                names = member.scope.table.components
                for name in names:
                    self.member(member, name)
                if list(member.members) != list(names):
                    ordered = {name: member.members[name] for name in names}
                    member.members.clear()
                    member.members.update(ordered)
                stack.extend([(m, depth + 1) for m in member.members.values() if not isinstance(m, Leaf)])
            elif isinstance(member, Array):
                stack.extend([(m, depth + 1) for m in member.items if not isinstance(m, Leaf)])
            elif isinstance(member, Outer) and member.own is not None:
                stack.append((member.own, depth))
            if not stack:
                stack = [(m, 1) for m in self._inners.added_to(root)]
        return root

    # ------------------------------------------------------------------ types

    @property
    def overdetermined(self) -> dict[str, Scope]:
        """The function `equalityConstraint` of each overdetermined record or type, by path (9.4)."""
        return self._overdetermined.functions

    def simple_type(self, scope: Scope) -> SimpleType | None:
        """What a type boils down to if it is (derived from) a predefined type or an enumeration."""
        return self._types.of(scope)

    def check_redeclared(self, scope: Scope) -> None:
        """Compare a class with its constraining classes, once."""
        if scope not in self._checked:
            self._checked.add(scope)
            check_used(scope, self._types)

    def size_so_far(self, instance: Instance, name: str, dimension: int) -> int | None:
        """The size in `dimension` (from 1) of an array being built, if it is already known."""
        sizes = self._building.get((instance, name), ())
        return sizes[dimension - 1] if 0 < dimension <= len(sizes) else None

    # ------------------------------------------------------------------ members

    def member(self, instance: Instance, name: str) -> Member | None:
        """The member `name`, built now if need be; None if the class has no such component."""
        found = instance.members.get(name)
        if found is None:
            entry = instance.scope.table.components.get(name)
            if entry is None:
                return None
            key = (instance, name)
            if key in self._building:
                raise cyclic_structure(entry, instance)
            self._building[key] = []
            try:
                found = self._build(entry, instance)
            finally:
                self._building.pop(key, None)  # an added `inner` component of this name took it out
            instance.members[name] = found
        return found.target if isinstance(found, Outer) else found

    def _build(self, entry: ComponentEntry, instance: Instance) -> Member | Outer:
        path = f"{instance.path}.{entry.name}" if instance.path else entry.name
        clause, declaration = entry.clause, entry.declaration
        context = Context(entry.scope, instance)
        if declaration.condition is not None and not self._is_there(declaration.condition, context, path):
            return Absent(path, declaration.span)
        if clause.prefixes.outer:
            if not clause.prefixes.inner:
                check_unmodified(entry, instance, path)
            if clause.prefixes.inner and instance.parent is None:
                self._translation.warnings.append(no_outer_around(entry.name, declaration.span))
                return self._declared(entry, instance, path)
            target = self._inners.find(entry, instance, path)
            own = self._declared(entry, instance, path) if clause.prefixes.inner else None
            return Outer(path, target, declaration.span, own)
        return self._declared(entry, instance, path)

    def _declared(self, entry: ComponentEntry, instance: Instance, path: str) -> Member:
        """The component that a declaration makes, with all modifiers that reach it."""
        clause, declaration, context = entry.clause, entry.declaration, Context(entry.scope, instance)
        outside = self._outside(entry, instance, path)
        if outside.redeclaration is not None:
            plan, modifier = self._redeclared(entry, outside, context, path)
        else:
            modifier = (
                merge(outside, bound(entry.own, instance), path) if entry.own is not NO_MODIFIER else outside
            )
            for below in entry.below:
                modifier = merge(modifier, bound(below, instance), path)
            prefixes = self._prefixes_of(entry, clause, instance)
            plan = Plan(path, clause, declaration, context, prefixes, self._type_of(entry))
        return self._shaped(plan, modifier, instance, entry.name)

    def _is_there(self, condition: ast.Expression, context: Context, path: str) -> bool:
        value = self._translation.evaluate(condition, context, f"the condition of `{path}`")
        if not isinstance(value, bool):
            message = f"the condition of `{path}` must be Boolean, but it is {value}"
            raise fail(TypeProblem, "type.not-boolean", message, condition.span, names=[path])
        return value

    def automatic(self, entry: ComponentEntry, root: Instance) -> Member:
        """An `inner` component that nobody declares, built from the declaration of an `outer` one."""
        scope = self._type_of(entry)
        plan = Plan(
            entry.name,
            entry.clause,
            entry.declaration,
            Context(entry.scope, root),
            Prefixes(),
            scope,
        )
        before = self._building  # may have it as an `outer` one, declared at the top itself
        self._building = before | {(root, entry.name): []}
        try:
            return self._shaped(plan, NO_MODIFIER, root, entry.name)
        finally:
            self._building = before

    def _outside(self, entry: ComponentEntry, instance: Instance, path: str) -> Modifier:
        """Modifiers from outside the declaring class: the component's own, then those of extends clauses."""
        modifier = instance.modifier.children.get(entry.name, NO_MODIFIER)
        if entry.protected and not modifier.is_empty and instance.parent is not None:
            raise modifies_protected(path, entry.scope, modifier)
        for through in entry.through:
            modifier = merge(modifier, bound(through, instance), path)
        if entry.clause.prefixes.final and not modifier.is_empty:
            raise overrides_final(path, modifier.span, entry.declaration.span)
        return modifier

    def _type_of(self, entry: ComponentEntry) -> Scope:
        found = self._type_scopes.get(entry)
        if found is None:
            found = self._type_scopes[entry] = entry.scope.find_class(entry.clause.type, complete=True)
            check_component_declaration(entry, found, self._types)
            self.check_redeclared(found)
        return found

    def _prefixes_of(
        self, entry: ComponentEntry, clause: ast.ComponentClause, instance: Instance
    ) -> Prefixes:
        if clause is not entry.clause:
            return component_prefixes(entry, clause, instance.prefixes)
        key = (entry, instance.prefixes)
        found = self._prefixes.get(key)
        if found is None:
            found = self._prefixes[key] = component_prefixes(entry, clause, instance.prefixes)
        return found

    def _redeclared(
        self, entry: ComponentEntry, outside: Modifier, context: Context, path: str
    ) -> tuple[Plan, Modifier]:
        """The plan of a component that a modification redeclares, and its modifier (7.3)."""
        redeclaration, instance = outside.redeclaration, context.instance
        assert redeclaration is not None  # the caller has looked
        assert instance is not None
        element = redeclaration.element
        if not isinstance(element, ast.ComponentClause):
            raise not_a_component(path, redeclaration.span)
        check_not_constant(entry, redeclaration.span)
        where, inside = redeclaration.context.scope, redeclaration.context.instance
        own = modifier_of(element.declarations[0].modification, redeclaration.context)
        kept = merge(redeclared_modifier(redeclaration), bound(entry.constraint, instance), path)
        below = merge(own, kept, path)
        beside = Modifier(
            outside.binding, outside.children, None, outside.final, outside.span, outside.beside
        )
        new = where.find_class(element.type)
        if not entry.clause.prefixes.replaceable and new is not self._type_of(entry):
            raise not_replaceable(path, redeclaration.span, entry.declaration.span)
        constraints = constraints_of(redeclaration, entry)
        check_component_redeclaration(path, new, constraints, redeclaration.span, self._types)
        declaration = element.declarations[0]
        has_sizes = declaration.dimensions is not None or element.dimensions is not None
        sized = declaration if has_sizes else entry.declaration
        plan = Plan(
            path,
            element if has_sizes else entry.clause,
            ast.Declaration(entry.name, sized.dimensions, None, None, declaration.comment, declaration.span),
            Context(where, inside) if has_sizes else context,
            self._prefixes_of(entry, element, instance),
            new,
        )
        return plan, merge(beside, below, path)

    def _shaped(self, plan: Plan, modifier: Modifier, instance: Instance, name: str) -> Member:
        simple = self._types.of(plan.type)
        if simple is not None:
            self._overdetermined.note_variable(plan)
        places = [(plan.declaration.dimensions, plan.context), (plan.clause.dimensions, plan.context)]
        if simple is not None:
            places += [(dimensions, Context(scope, None)) for dimensions, scope in simple.dimensions]
        written = [(d, where) for d, where in places if d is not None]
        if not written:
            return self._element(plan, simple, plan.path, modifier, instance)
        sizes = self._building[instance, name]
        shape = array_shape(
            self._translation,
            written,
            modifier,
            plan.path,
            plan.declaration.span,
            sizes,
            growing=instance.is_expandable,
        )

        def build(path: str, part: Modifier) -> Member:
            return self._element(plan, simple, path, part, instance)

        return array_of(plan, shape, simple, modifier, build)

    def _element(
        self, plan: Plan, simple: SimpleType | None, path: str, modifier: Modifier, instance: Instance
    ) -> Member:
        self._count += 1
        if self._count > MAX_MEMBERS:
            raise too_large(path, plan.declaration.span, MAX_MEMBERS)
        if simple is not None:
            return self._leaf(plan, simple, path, modifier)
        return self._component(plan, path, modifier, instance)

    def _leaf(self, plan: Plan, simple: SimpleType, path: str, modifier: Modifier) -> Leaf:
        prefixes = plan.prefixes
        if simple.causality is not prefixes.causality and prefixes.causality is Causality.LOCAL:
            prefixes = with_causality(prefixes, simple.causality)
        if modifier.final and not prefixes.final:
            prefixes = replace(prefixes, final=True)
        if prefixes.connection is Connection.STREAM:
            self.has_streams = True
            check_stream(path, simple.scalar, plan)
        return Leaf(
            path,
            simple.scalar,
            discrete_default(prefixes, simple.scalar),
            self._attributes_of(simple, modifier, path),
            modifier.binding,
            plan.declaration.span,
            plan.declaration.comment.text or "",
            simple.connector,
        )

    def _attributes_of(self, simple: SimpleType, modifier: Modifier, path: str) -> dict[str, Binding]:
        """One dictionary for all leaves whose attributes come from the same modifiers."""
        if not modifier.children:
            return simple.attributes
        key = (simple, tuple(modifier.children.values()))
        found = self._attributes.get(key)
        if found is None:
            found = self._attributes[key] = with_attributes(simple, modifier, path)
        return found

    def _component(self, plan: Plan, path: str, modifier: Modifier, parent: Instance) -> Instance:
        scope = plan.type.modified(modifier)
        check_instantiable(scope, path, plan.clause.type.span)
        self.check_redeclared(scope)
        if not plan.type.modifier.is_empty:
            modifier = merge(modifier, bound(plan.type.modifier, parent), path)
        if isinstance(scope.definition, ast.LongClass) and not scope.below.is_empty:
            modifier = merge(modifier, bound(scope.below, parent), path)
        check_targets(scope, modifier)
        if scope.kind == "record":
            self._overdetermined.note(scope, path)
        modifier = spread_record(modifier, scope)
        prefixes = inherit_kind(plan.prefixes, scope)
        description = plan.declaration.comment.text or ""
        if path.count(".") > MAX_DEPTH:
            raise too_deep(parent, MAX_DEPTH)
        made = Instance(path, scope, parent, prefixes, plan.declaration.span, description, modifier)
        self.has_expandable = self.has_expandable or made.is_expandable
        return made
