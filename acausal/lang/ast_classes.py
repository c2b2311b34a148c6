"""AST of modifications, declarations and classes (Modelica 3.6, A.2.1 to A.2.5)."""

from __future__ import annotations

from dataclasses import field
from typing import Literal

from acausal.errors import Span
from acausal.lang.ast_equations import AlgorithmSection, ConnectEquation, EquationSection, External
from acausal.lang.ast_expressions import ComponentReference, Expression, Subscripts
from acausal.lang.ast_node import node, span_field

# --------------------------------------------------------------------------- modifications


@node
class Annotation:
    """`annotation(...)`: kept as written."""

    arguments: tuple[Argument, ...]
    span: Span = span_field()


@node
class Comment:
    """A description string (concatenated parts) and an annotation, both optional."""

    text: str | None
    annotation: Annotation | None


@node
class Modification:
    """`(arguments)`, `= value`, `:= value` or both; `value` is the expression, or `Break` for `= break`."""

    arguments: tuple[Argument, ...]
    value: Expression | Break | None
    span: Span = span_field()


@node
class Break:
    """`= break` in a modification (removes a modifier)."""

    span: Span = span_field()


@node
class ElementModification:
    """`[each] [final] a.b(…) = value "comment"` inside a modification."""

    name: tuple[str, ...]
    modification: Modification | None
    each: bool
    final: bool
    comment: Comment
    span: Span = span_field()


@node
class ElementRedeclaration:
    """`redeclare [each] [final] ...` or `[each] [final] replaceable ...` inside a modification."""

    element: ShortClass | EnumerationClass | ComponentClause
    redeclare: bool
    each: bool
    final: bool
    replaceable: bool
    constraint: Constraint | None
    span: Span = span_field()


@node
class BreakConnect:
    """`break connect(a, b)` or `break name` in the modification of an `extends` (selective extension)."""

    equation: ConnectEquation | None
    name: str | None
    span: Span = span_field()


Argument = ElementModification | ElementRedeclaration | BreakConnect


# --------------------------------------------------------------------------- elements and classes

Flow = Literal["", "flow", "stream"]
Variability = Literal["", "discrete", "parameter", "constant"]
Causality = Literal["", "input", "output"]
Purity = Literal["", "pure", "impure"]
ClassKind = Literal[
    "class",
    "model",
    "record",
    "block",
    "connector",
    "type",
    "package",
    "function",
    "operator",
]


@node
class Prefixes:
    """Prefixes of an element: `redeclare final inner outer replaceable`, and whether it is `protected`."""

    redeclare: bool = False
    final: bool = False
    inner: bool = False
    outer: bool = False
    replaceable: bool = False
    protected: bool = False


@node
class Constraint:
    """`constrainedby Type(modification) "comment"`."""

    type: ComponentReference
    modification: Modification | None
    comment: Comment
    span: Span = span_field()


@node
class Import:
    """`import A.B;` `import D = A.B;` (alias) `import A.*;` (wildcard) `import A.{B, C};` (group)."""

    name: tuple[str, ...]
    alias: str | None
    wildcard: bool
    group: tuple[str, ...]
    comment: Comment
    span: Span = span_field()


@node
class Extends:
    type: ComponentReference
    modification: Modification | None
    annotation: Annotation | None
    protected: bool
    span: Span = span_field()


@node
class Declaration:
    """One declared component: `name[dimensions](modification) = value if condition "comment"`."""

    name: str
    dimensions: Subscripts | None
    modification: Modification | None
    condition: Expression | None
    comment: Comment
    span: Span = span_field()


@node
class ComponentClause:
    """`flow Real[3] a, b = 1;`: type prefixes, type, array dimensions of the type, declarations."""

    prefixes: Prefixes
    flow: Flow
    variability: Variability
    causality: Causality
    type: ComponentReference
    dimensions: Subscripts | None
    declarations: tuple[Declaration, ...]
    constraint: Constraint | None
    span: Span = span_field()


@node
class EnumerationLiteral:
    name: str
    comment: Comment
    span: Span = span_field()


@node
class Composition:
    """The body of a long class: elements in order, sections in order, external, annotation."""

    elements: tuple[Element, ...]
    sections: tuple[EquationSection | AlgorithmSection, ...]
    external: External | None
    annotation: Annotation | None


@node
class ClassPrefixes:
    """`encapsulated`, `partial`, `expandable`, `operator`, `pure`/`impure` in front of a class kind."""

    encapsulated: bool = False
    partial: bool = False
    expandable: bool = False
    operator: bool = False
    purity: Purity = ""


@node
class LongClass:
    """`model Name "comment" … end Name;`, or `model extends Name(mod) … end Name;` when `extends` is true."""

    name: str
    kind: ClassKind
    class_prefixes: ClassPrefixes
    prefixes: Prefixes
    extends: bool
    modification: Modification | None
    comment: str | None
    body: Composition
    constraint: Constraint | None
    span: Span = span_field()


@node
class ShortClass:
    """`type Name = input Base[3](mod) "comment"`."""

    name: str
    kind: ClassKind
    class_prefixes: ClassPrefixes
    prefixes: Prefixes
    causality: Causality
    base: ComponentReference
    dimensions: Subscripts | None
    modification: Modification | None
    comment: Comment
    constraint: Constraint | None
    span: Span = span_field()


@node
class EnumerationClass:
    """`type E = enumeration(a, b)`; `literals` is None for `enumeration(:)`."""

    name: str
    kind: ClassKind
    class_prefixes: ClassPrefixes
    prefixes: Prefixes
    literals: tuple[EnumerationLiteral, ...] | None
    comment: Comment
    constraint: Constraint | None
    span: Span = span_field()


@node
class DerClass:
    """`function f_x = der(f, x)`: a partial derivative of a function."""

    name: str
    kind: ClassKind
    class_prefixes: ClassPrefixes
    prefixes: Prefixes
    base: ComponentReference
    variables: tuple[str, ...]
    comment: Comment
    constraint: Constraint | None
    span: Span = span_field()


ClassDefinition = LongClass | ShortClass | EnumerationClass | DerClass
Element = Import | Extends | ComponentClause | ClassDefinition


@node
class StoredDefinition:
    """One file: `within A.B;` (None when absent, () for a bare `within;`) and its classes."""

    within: tuple[str, ...] | None
    classes: tuple[tuple[bool, ClassDefinition], ...]
    """(`final` prefix, class) pairs."""
    source: str = field(compare=False, repr=False)
    """Path of the file, for messages."""
