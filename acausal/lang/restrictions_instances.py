"""What a component may be, judged in the instance tree (Modelica 3.6, 4.4.2.2, 4.6, 9.3 and 9.3.1).

`check_instances` looks at the components of each class once, however often the class is used,
`check_connectors` at the variables of each connector, whose number depends on parameters. Both are linear in
the size of the tree.
"""

from __future__ import annotations

from acausal.errors import AcausalError, Span, TypeProblem, fail
from acausal.lang import ast
from acausal.lang.class_table import ComponentEntry
from acausal.lang.flat import Causality, Variability
from acausal.lang.instance import Array, Connection, Instance, Leaf, Member, Outer, Prefixes, leaves
from acausal.lang.predefined import EXTERNAL_OBJECT
from acausal.lang.restrictions import kind_name
from acausal.lang.restrictions_outer import check_outer
from acausal.lang.scope import Scope
from acausal.lang.translation import Translation

_STRUCTURED = ("record", "connector", "type")
_INSIDE: dict[str, tuple[str, ...]] = {
    "record": ("record", "type"),
    "connector": ("record", "type", "connector"),
}
_CONSTRAINT = "equalityConstraint"


def check_instances(root: Instance, translation: Translation) -> None:
    """Raise for the first component that breaks a rule, and for redeclared classes, used or not."""
    seen: set[tuple[Scope, Prefixes]] = set()
    stack: list[Member | Outer] = [root]
    while stack:
        member = stack.pop()
        if isinstance(member, Array):
            if member.type is None:
                stack.extend(reversed(member.items))
        elif isinstance(member, Instance):
            key = (member.scope, member.prefixes)
            if key not in seen:
                seen.add(key)
                _check_parts(member)
                for scope in _redeclared(member.scope):
                    translation.instances.check_redeclared(scope)
            for name, part in member.members.items():
                if isinstance(part, Outer):
                    check_outer(member, name, part, translation)
            if member.scope.kind == "block":
                _check_directions(member)
            stack.extend([part for part in reversed(member.members.values()) if not isinstance(part, Leaf)])


def check_connectors(root: Instance) -> None:
    """Raise `TypeProblem` `connector.unbalanced` for the first connector with unequal numbers (9.3.1)."""
    stack: list[Member | Outer] = [root]
    while stack:
        member = stack.pop()
        if isinstance(member, Array):
            if member.type is None:
                stack.extend(reversed(member.items))
        elif isinstance(member, Instance) and member.is_connector:
            _check_balance(member)
        elif isinstance(member, Instance):
            stack.extend([part for part in reversed(member.members.values()) if not isinstance(part, Leaf)])


def _redeclared(scope: Scope) -> list[Scope]:
    """The classes of a class that are redeclared, used or not."""
    found = [entry for entry in scope.table.classes.values() if entry.modifier.redeclaration is not None]
    return [scope.nested(entry) for entry in found]


def _error(code: str, message: str, span: Span, section: str, *names: str) -> AcausalError:
    return fail(TypeProblem, code, message, span, names=names, hint=f"see Modelica 3.6, {section}")


# --------------------------------------------------------------------------- kinds and prefixes


def _check_parts(instance: Instance) -> None:
    allowed = _INSIDE.get(instance.scope.kind)
    for name, entry in instance.scope.table.components.items():
        member = _element_of(instance.members.get(name))
        if isinstance(member, Leaf) and member.connector:
            _check_variable_connector(entry)
        if isinstance(member, Instance):
            scope = member.scope
            _check_kind(entry, scope)
            if allowed is not None and scope.kind not in allowed:
                around = kind_name(instance.scope.definition)
                message = (
                    f"`{name}` in the {around} `{instance.scope.path}` is a {kind_name(scope.definition)}, "
                    f"`{scope.path}`; only {' and '.join(allowed)} are allowed there"
                )
                raise _error("component.kind", message, entry.declaration.span, "4.6", name, scope.path)
        _check_nested_prefix(instance, name, entry)


def _element_of(member: Member | Outer | None) -> Member | Outer | None:
    """A component; of an array, its first element."""
    while isinstance(member, Array) and member.items:
        member = member.items[0]
    return member


def _prefix_of(entry: ComponentEntry) -> str:
    clause = entry.clause
    return clause.flow or clause.variability or clause.causality


def _check_kind(entry: ComponentEntry, scope: Scope) -> None:
    """`flow`, `parameter`, `input` and so on are for types, records and connectors (4.4.2.2)."""
    prefix, name = _prefix_of(entry), entry.name
    if not prefix:
        return
    if scope.kind not in _STRUCTURED and not _is_external(scope):
        message = f"`{name}` is of the {scope.kind} `{scope.path}` and cannot have the prefix `{prefix}`"
        raise _error("component.prefix", message, entry.clause.span, "4.4.2.2", name)
    if scope.kind == "connector":
        _check_variable_connector(entry)
    _check_flow_record(entry, scope)


def _check_variable_connector(entry: ComponentEntry) -> None:
    prefix = entry.clause.variability
    if prefix in ("parameter", "constant"):
        message = f"the connector `{entry.name}` cannot have the prefix `{prefix}`"
        raise _error("component.prefix", message, entry.clause.span, "9.3", entry.name)


def _check_flow_record(entry: ComponentEntry, scope: Scope) -> None:
    """A flow of an operator record can be added: it has `'0'`, `'+'` and `'-'` (9.2)."""
    if not entry.clause.flow or not scope.definition.class_prefixes.operator:
        return
    missing = [name for name in ("'0'", "'+'", "'-'") if scope.find_class_entry(name) is None]
    if missing:
        message = f"the flow `{entry.name}` is of the operator record `{scope.path}`, which has no operator "
        message += " and no ".join(f"`{name}`" for name in missing)
        raise _error("component.flow-record", message, entry.clause.span, "9.2", entry.name, scope.path)


def _is_external(scope: Scope) -> bool:
    return any(base.scope.path == EXTERNAL_OBJECT for base in scope.table.bases)


def _check_nested_prefix(instance: Instance, name: str, entry: ComponentEntry) -> None:
    """What has `flow`, `input` or `output` has no parts with such a prefix (4.4.2.2)."""
    outer = instance.prefixes
    if outer.causality is Causality.LOCAL and outer.connection is Connection.POTENTIAL:
        return
    own = entry.clause.flow or entry.clause.causality
    if own:
        around = outer.connection.value or outer.causality.value
        message = f"`{name}` has the prefix `{own}`, but `{instance.path}` around it is already `{around}`"
        raise _error(
            "component.nested-prefix", message, entry.declaration.span, "4.4.2.2", f"{instance.path}.{name}"
        )


# --------------------------------------------------------------------------- connectors


def _check_balance(connector: Instance) -> None:
    """As many flow variables as others without a direction (9.3.1)."""
    definition = connector.scope.definition
    if definition.class_prefixes.partial or definition.class_prefixes.expandable:
        return
    flows = potentials = 0
    for leaf in leaves(connector):
        prefixes = leaf.prefixes
        if prefixes.variability <= Variability.PARAMETER or prefixes.causality is not Causality.LOCAL:
            continue
        if prefixes.connection is Connection.FLOW:
            flows += 1
        elif prefixes.connection is Connection.POTENTIAL:
            potentials += 1
    if flows != potentials:
        potentials += _overdetermined(connector)
    if flows != potentials:
        raise fail(
            TypeProblem,
            "connector.unbalanced",
            f"the connector `{connector.path}` has {_count(flows, 'flow variable')} and "
            f"{_count(potentials, 'potential variable')}; the numbers must be equal",
            connector.span,
            names=[connector.path, connector.scope.path],
            hint=f"see `{connector.scope.path}` at {connector.scope.span} (Modelica 3.6, 9.3.1)",
        )


def _count(number: int, what: str) -> str:
    return f"{number} {what}" + ("" if number == 1 else "s")


def _overdetermined(connector: Instance) -> int:
    """How many variables of overdetermined types and records do not count (9.3.1): a number below zero."""
    difference = 0
    stack = [connector]
    while stack:
        instance = stack.pop()
        for name, member in instance.members.items():
            entry = instance.scope.table.components[name]
            residue = _residue_size(entry.scope.find_class(entry.clause.type))
            if isinstance(member, Outer) or entry.clause.flow:
                continue
            if residue is not None:
                difference += residue - len(list(leaves(member)))
            elif isinstance(member, Instance):
                stack.append(member)
            elif isinstance(member, Array):
                stack.extend([item for item in member.items if isinstance(item, Instance)])
    return difference


def _residue_size(scope: Scope) -> int | None:
    """The size of the result of the class's `equalityConstraint` function; None if it has none."""
    entry = None if scope.is_predefined else scope.find_class_entry(_CONSTRAINT)
    if entry is None:
        return None
    for output in scope.nested(entry).table.components.values():
        sizes = output.declaration.dimensions or output.clause.dimensions
        if output.clause.causality == "output" and sizes is not None:
            size = sizes.items[0]
            return size.value if isinstance(size, ast.IntegerLiteral) else None
    return None


def _check_directions(block: Instance) -> None:
    """Every variable of a block's public connectors is an input or an output (4.6)."""
    for name, member in block.members.items():
        entry = block.scope.table.components.get(name)
        first = _element_of(member)
        if entry is None or entry.protected or not isinstance(first, Instance) or isinstance(member, Outer):
            continue
        if not first.is_connector or first.scope.definition.class_prefixes.expandable:
            continue
        for leaf in leaves(member):
            prefixes = leaf.prefixes
            if prefixes.causality is Causality.LOCAL and prefixes.variability > Variability.PARAMETER:
                raise fail(
                    TypeProblem,
                    "connector.undirected",
                    f"`{leaf.path}` is neither input nor output, but `{block.scope.path}` is a block",
                    entry.declaration.span,
                    names=[leaf.path],
                    hint="make it a model, or give the connector's variables a direction (Modelica 3.6, 4.6)",
                )
