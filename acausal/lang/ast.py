"""The AST: exactly the source, every node with its span. Data only; see `parser` and `printer`.

The node classes follow the concrete syntax of the Modelica Language Specification 3.6, appendix A, and
cover all of it, also what later stages still refuse. `parse -> print -> parse` is the identity up to
spans: equality of nodes ignores `span`, and parentheses that only group are not represented (the printer
puts them back by precedence).

Nodes are immutable to a type checker (`dataclass_transform(frozen_default=True)`); at run time they are
plain slotted dataclasses because a frozen one takes four times as long to build, and a library has
millions of nodes.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Literal, TypeVar, dataclass_transform

from acausal.errors import Span

_T = TypeVar("_T")


@dataclass_transform(frozen_default=True, kw_only_default=False, field_specifiers=(field,))
def node(cls: type[_T]) -> type[_T]:
    """Class decorator of every AST node."""
    make: Callable[[type[_T]], type[_T]] = dataclass(slots=True, eq=True)
    return make(cls)


def _span() -> Span:
    return field(compare=False, repr=False)


# --------------------------------------------------------------------------- names


@node
class Subscripts:
    """`[i, j, :]`; a lone colon is `Colon`."""

    items: tuple[Expression, ...]
    span: Span = _span()


@node
class NamePart:
    """One identifier of a dotted reference with its subscripts: `cell[3]` in `line.cell[3].p`.

    A quoted identifier keeps its quotes: `'cell 3'` is not the same name as `cell`.
    """

    name: str
    subscripts: Subscripts | None
    span: Span = _span()


@node
class ComponentReference:
    """`a.b[1].c`, or `.Modelica.Constants.pi` when `global_` is true. Also type names and function names."""

    parts: tuple[NamePart, ...]
    global_: bool
    span: Span = _span()

    @property
    def text(self) -> str:
        """The dotted name without subscripts."""
        return ("." if self.global_ else "") + ".".join([part.name for part in self.parts])


# --------------------------------------------------------------------------- expressions


@node
class RealLiteral:
    value: float
    span: Span = _span()


@node
class IntegerLiteral:
    value: int
    span: Span = _span()


@node
class BooleanLiteral:
    value: bool
    span: Span = _span()


@node
class StringLiteral:
    """`value` is the string's content after escape sequences are applied."""

    value: str
    span: Span = _span()


UnaryOperator = Literal["-", "+", ".-", ".+", "not"]
BinaryOperator = Literal[
    "+", "-", "*", "/", "^", ".+", ".-", ".*", "./", ".^", "<", "<=", ">", ">=", "==", "<>", "and", "or"
]


@node
class Unary:
    operator: UnaryOperator
    operand: Expression
    span: Span = _span()


@node
class Binary:
    operator: BinaryOperator
    left: Expression
    right: Expression
    span: Span = _span()


@node
class If:
    """`if c1 then e1 elseif c2 then e2 else e3`: `branches` are the (condition, value) pairs."""

    branches: tuple[tuple[Expression, Expression], ...]
    otherwise: Expression
    span: Span = _span()


@node
class NamedArgument:
    """`name = value` in a call; `value` may be a `PartialFunction`."""

    name: str
    value: Expression
    span: Span = _span()


@node
class Iterator:
    """`i in range`; `range` is None where it is deduced from the use of `i` as a subscript."""

    name: str
    range: Expression | None
    span: Span = _span()


@node
class Call:
    """`f(a, b, c = d)`, a reduction `sum(e for i in r)` when `iterators` is not empty.

    `der(x)`, `initial()` and `pure(f(x))` are calls too: their function is a one-part reference.
    """

    function: ComponentReference
    arguments: tuple[Expression, ...]
    named: tuple[NamedArgument, ...]
    iterators: tuple[Iterator, ...]
    span: Span = _span()


@node
class PartialFunction:
    """`function f(a = 1)`: a function with some arguments bound, passed as an argument."""

    function: ComponentReference
    named: tuple[NamedArgument, ...]
    span: Span = _span()


@node
class ArrayConstructor:
    """`{a, b, c}`, or `{e for i in r}` when `iterators` is not empty (then `items` has one element)."""

    items: tuple[Expression, ...]
    iterators: tuple[Iterator, ...]
    span: Span = _span()


@node
class Matrix:
    """`[a, b; c, d]`: rows of expressions."""

    rows: tuple[tuple[Expression, ...], ...]
    span: Span = _span()


@node
class Range:
    """`start : stop` or `start : step : stop`."""

    start: Expression
    step: Expression | None
    stop: Expression
    span: Span = _span()


@node
class Tuple:
    """`(a, , b)` as the left side of a call with several results; `()` too. Left-out positions are None.

    A single parenthesised expression is not a tuple, except on the left of `:=`.
    """

    items: tuple[Expression | None, ...]
    span: Span = _span()


@node
class Colon:
    """`:` as a subscript or array dimension."""

    span: Span = _span()


@node
class End:
    """`end` inside a subscript."""

    span: Span = _span()


@node
class Subscripted:
    """`(expression)[i]`: Base Modelica and Modelica 3.7 have it, Modelica 3.6 (section 3.2) forbids it."""

    expression: Expression
    subscripts: Subscripts
    span: Span = _span()


Expression = (
    RealLiteral
    | IntegerLiteral
    | BooleanLiteral
    | StringLiteral
    | ComponentReference
    | Unary
    | Binary
    | If
    | Call
    | PartialFunction
    | ArrayConstructor
    | Matrix
    | Range
    | Tuple
    | Colon
    | End
    | Subscripted
)


# --------------------------------------------------------------------------- modifications


@node
class Annotation:
    """`annotation(...)`: kept as written."""

    arguments: tuple[Argument, ...]
    span: Span = _span()


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
    span: Span = _span()


@node
class Break:
    """`= break` in a modification (removes a modifier)."""

    span: Span = _span()


@node
class ElementModification:
    """`[each] [final] a.b(…) = value "comment"` inside a modification."""

    name: tuple[str, ...]
    modification: Modification | None
    each: bool
    final: bool
    comment: Comment
    span: Span = _span()


@node
class ElementRedeclaration:
    """`redeclare [each] [final] ...` or `[each] [final] replaceable ...` inside a modification."""

    element: ShortClass | EnumerationClass | ComponentClause
    redeclare: bool
    each: bool
    final: bool
    replaceable: bool
    constraint: Constraint | None
    span: Span = _span()


@node
class BreakConnect:
    """`break connect(a, b)` or `break name` in the modification of an `extends` (selective extension)."""

    equation: ConnectEquation | None
    name: str | None
    span: Span = _span()


Argument = ElementModification | ElementRedeclaration | BreakConnect


# --------------------------------------------------------------------------- equations and statements


@node
class EqualEquation:
    """`left = right`."""

    left: Expression
    right: Expression
    comment: Comment
    span: Span = _span()


@node
class ConnectEquation:
    left: ComponentReference
    right: ComponentReference
    comment: Comment
    span: Span = _span()


@node
class CallEquation:
    """`assert(...)`, `reinit(...)`, `Connections.root(...)`, or any function call as an equation."""

    call: Call
    comment: Comment
    span: Span = _span()


@node
class IfEquation:
    branches: tuple[tuple[Expression, tuple[Equation, ...]], ...]
    otherwise: tuple[Equation, ...]
    comment: Comment
    span: Span = _span()


@node
class ForEquation:
    iterators: tuple[Iterator, ...]
    body: tuple[Equation, ...]
    comment: Comment
    span: Span = _span()


@node
class WhenEquation:
    """`when c then … elsewhen d then … end when`: (condition, body) pairs."""

    branches: tuple[tuple[Expression, tuple[Equation, ...]], ...]
    comment: Comment
    span: Span = _span()


Equation = EqualEquation | ConnectEquation | CallEquation | IfEquation | ForEquation | WhenEquation


@node
class Assignment:
    """`target := value`; `target` is a `Tuple` for a call with several results."""

    target: ComponentReference | Tuple
    value: Expression
    comment: Comment
    span: Span = _span()


@node
class CallStatement:
    call: Call
    comment: Comment
    span: Span = _span()


@node
class IfStatement:
    branches: tuple[tuple[Expression, tuple[Statement, ...]], ...]
    otherwise: tuple[Statement, ...]
    comment: Comment
    span: Span = _span()


@node
class ForStatement:
    iterators: tuple[Iterator, ...]
    body: tuple[Statement, ...]
    comment: Comment
    span: Span = _span()


@node
class WhileStatement:
    condition: Expression
    body: tuple[Statement, ...]
    comment: Comment
    span: Span = _span()


@node
class WhenStatement:
    branches: tuple[tuple[Expression, tuple[Statement, ...]], ...]
    comment: Comment
    span: Span = _span()


@node
class BreakStatement:
    comment: Comment
    span: Span = _span()


@node
class ReturnStatement:
    comment: Comment
    span: Span = _span()


Statement = (
    Assignment
    | CallStatement
    | IfStatement
    | ForStatement
    | WhileStatement
    | WhenStatement
    | BreakStatement
    | ReturnStatement
)


@node
class EquationSection:
    """`equation` or `initial equation`."""

    equations: tuple[Equation, ...]
    initial: bool
    span: Span = _span()


@node
class AlgorithmSection:
    """`algorithm` or `initial algorithm`."""

    statements: tuple[Statement, ...]
    initial: bool
    span: Span = _span()


@node
class External:
    """`external "C" result = name(arguments) annotation(...)`."""

    language: str | None
    result: ComponentReference | None
    name: str | None
    arguments: tuple[Expression, ...]
    annotation: Annotation | None
    span: Span = _span()


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
    span: Span = _span()


@node
class Import:
    """`import A.B;` `import D = A.B;` (alias) `import A.*;` (wildcard) `import A.{B, C};` (group)."""

    name: tuple[str, ...]
    alias: str | None
    wildcard: bool
    group: tuple[str, ...]
    comment: Comment
    span: Span = _span()


@node
class Extends:
    type: ComponentReference
    modification: Modification | None
    annotation: Annotation | None
    protected: bool
    span: Span = _span()


@node
class Declaration:
    """One declared component: `name[dimensions](modification) = value if condition "comment"`."""

    name: str
    dimensions: Subscripts | None
    modification: Modification | None
    condition: Expression | None
    comment: Comment
    span: Span = _span()


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
    span: Span = _span()


@node
class EnumerationLiteral:
    name: str
    comment: Comment
    span: Span = _span()


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
    span: Span = _span()


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
    span: Span = _span()


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
    span: Span = _span()


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
    span: Span = _span()


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
