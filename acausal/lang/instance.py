"""The instance tree: names resolved, modifiers and redeclarations applied, sizes known, conditions decided.

`Instance` is a component with parts, `Leaf` a scalar of a predefined or enumeration type, `Array` holds
the elements of an array of either, `Absent` is a conditional component that is not there, and `Outer` the
use of an `inner` component elsewhere.
`print_instance` shows the tree.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from enum import Enum

from acausal.errors import Span
from acausal.lang import ast
from acausal.lang.flat import Causality, ScalarType, Variability
from acausal.lang.light import light_object
from acausal.lang.modifiers import NO_MODIFIER, Binding, Modifier
from acausal.lang.scope import Scope


class Connection(Enum):
    """The prefix of a variable in a connector."""

    POTENTIAL = ""
    FLOW = "flow"
    STREAM = "stream"


@dataclass(frozen=True, slots=True)
class Prefixes:
    """What a component hands down to its parts."""

    variability: Variability = Variability.CONTINUOUS
    causality: Causality = Causality.LOCAL
    connection: Connection = Connection.POTENTIAL
    protected: bool = False
    final: bool = False
    evaluate: bool = False
    """`annotation(Evaluate = true)` of a parameter: its value is used at compile time (18.3)."""


@light_object
class Leaf:
    """A scalar variable, parameter or constant; `attributes` (start, unit, ...) and `binding` as written."""

    path: str
    type: ScalarType
    prefixes: Prefixes
    attributes: dict[str, Binding]
    binding: Binding | None
    span: Span
    description: str
    connector: bool = False
    """Declared with a connector class, such as `connector RealInput = input Real`."""


@light_object
class Array:
    """Elements of an array component, row by row."""

    path: str
    shape: tuple[int, ...]
    items: tuple[Member, ...]
    type: ScalarType | None
    """Of an array of scalars, also of an empty one."""
    span: Span
    element: Scope | None = None
    """The class of the elements; it says what an empty array holds."""


@light_object
class Absent:
    """A conditional component whose condition is false.

    `potential` marks a variable of an expandable connector that nothing makes present (9.1.3).
    """

    path: str
    span: Span
    potential: bool = False


@light_object
class Outer:
    """An `outer` component: the `inner` one that it stands for.

    `own` is the component that an `inner outer` declares for the components below.
    """

    path: str
    target: Leaf | Array | Absent | Instance
    span: Span
    own: Leaf | Array | Absent | Instance | None = None


@light_object
class Instance:
    """A component with parts. `members` is filled by the builder, name by name, and complete in the end.

    `constants` marks the holder of a package's constants, which is no component: they are used by value.
    """

    path: str
    scope: Scope
    parent: Instance | None
    prefixes: Prefixes
    span: Span
    description: str = ""
    modifier: Modifier = NO_MODIFIER
    members: dict[str, Member | Outer] = field(default_factory=dict[str, "Member | Outer"])
    constants: bool = False

    @property
    def is_connector(self) -> bool:
        return self.scope.kind == "connector"

    @property
    def is_expandable(self) -> bool:
        """Whether connections may add variables to this connector (9.1.3)."""
        return self.scope.kind == "connector" and _expandable(self.scope)

    @property
    def is_record(self) -> bool:
        return self.scope.kind in ("record", "operator")

    def nearest(self, scope: Scope) -> Instance | None:
        """This component or the nearest around it whose class is, or inherits from, that of `scope`."""
        current: Instance | None = self
        while current is not None:
            if scope.node in current.scope.table.lineage:
                return current
            current = current.parent
        return None


def _expandable(scope: Scope) -> bool:
    definition = scope.definition
    if isinstance(definition, ast.ShortClass) and not definition.class_prefixes.expandable:
        return _expandable(scope.table.bases[0].scope)
    return definition.class_prefixes.expandable


Member = Leaf | Array | Absent | Instance


def leaves(member: Member) -> Iterator[Leaf]:
    """All scalars below a member, depth first in order of declaration."""
    stack: list[Member | Outer] = [member]
    while stack:
        current = stack.pop()
        if isinstance(current, Leaf):
            yield current
        elif isinstance(current, Array):
            stack.extend(reversed(current.items))
        elif isinstance(current, Instance):
            stack.extend(reversed(current.members.values()))
        elif isinstance(current, Outer) and current.own is not None:
            stack.append(current.own)


def print_instance(root: Instance) -> str:
    """The tree as indented text: one line a component, `name : class`, scalars with their prefixes."""
    lines = [f"{root.scope.path}"]
    stack: list[tuple[str, Member | Outer, int]] = [(n, m, 1) for n, m in reversed(root.members.items())]
    while stack:
        name, member, depth = stack.pop()
        pad = "  " * depth
        if isinstance(member, Leaf):
            variability = member.prefixes.variability
            prefix = "" if variability is Variability.CONTINUOUS else variability.name.lower() + " "
            flow = "flow " if member.prefixes.connection is Connection.FLOW else ""
            lines.append(f"{pad}{flow}{prefix}{member.type} {name}")
        elif isinstance(member, Array):
            lines.append(f"{pad}{name}[{', '.join(map(str, member.shape))}]")
            numbered = [(f"[{i}]", item, depth + 1) for i, item in enumerate(member.items, start=1)]
            if not all(isinstance(item, Leaf) for item in member.items):
                stack.extend(reversed(numbered))
        elif isinstance(member, Absent):
            lines.append(f"{pad}{name} (absent)")
        elif isinstance(member, Outer):
            lines.append(f"{pad}{name} is the inner {member.target.path}")
            if member.own is not None:
                stack.append((f"{name} (inner)", member.own, depth))
        else:
            lines.append(f"{pad}{name} : {member.scope.path}")
            stack.extend((n, m, depth + 1) for n, m in reversed(member.members.items()))
    return "\n".join(lines) + "\n"
