"""What the parts of the front end that evaluate expressions need from each other.

`Translation` is the translator as seen by lookup, functions and the builder of instances; `Instances` is
that builder as seen by them. Both are implemented once: `translate.Translator`, `instantiate.Instantiator`.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field
from typing import TYPE_CHECKING, Protocol, TypeVar

from acausal.errors import Diagnostic, Span
from acausal.lang import ast
from acausal.lang.externals import Externals
from acausal.lang.flat import Assertion
from acausal.lang.instance import Instance, Leaf, Member
from acausal.lang.light import light_object
from acausal.lang.modifiers import Binding, Context
from acausal.lang.scope import Scope
from acausal.lang.simple_types import SimpleType
from acausal.lang.values import AnyValue, Value
from acausal.symbolic.expressions.expr import Constant, Expr

_T = TypeVar("_T")
_V = TypeVar("_V", bound=AnyValue)

if TYPE_CHECKING:
    from acausal.lang.formals import Formal
    from acausal.lang.network import Network


@light_object
class Env:
    """Where an expression is translated: its context and local names (iterators, function variables)."""

    context: Context
    locals: Mapping[str, AnyValue] = field(default_factory=dict[str, AnyValue])
    size: Value | None = None
    """Of the dimension being subscripted: the value of `end`."""
    depth: int = 0
    """How many function calls deep."""
    current: Mapping[Expr, Expr] = field(default_factory=dict[Expr, Expr])
    """Values that variables have at this point of an algorithm section."""
    at_event: bool = False
    """In a when-clause or an initial section, where every variable is discrete."""
    connecting: bool = False
    """In `connect`, which may name what only connections declare (9.1.3)."""
    owner: Instance | None = None
    """In a function: the component whose class has the function, for the values of modifications there."""

    def with_locals(self, more: Mapping[str, AnyValue]) -> Env:
        locals_ = {**self.locals, **more}
        return Env(
            self.context,
            locals_,
            self.size,
            self.depth,
            self.current,
            self.at_event,
            self.connecting,
            self.owner,
        )

    def with_size(self, size: Value) -> Env:
        return Env(
            self.context,
            self.locals,
            size,
            self.depth,
            self.current,
            self.at_event,
            self.connecting,
            self.owner,
        )

    def owned_by(self, owner: Instance) -> Env:
        """For the call of a function of this component."""
        context, size, depth = self.context, self.size, self.depth
        return Env(context, self.locals, size, depth, self.current, self.at_event, self.connecting, owner)

    def with_event(self) -> Env:
        """The same place at an event."""
        return Env(self.context, self.locals, self.size, self.depth, self.current, at_event=True)

    def without_current(self) -> Env:
        """The same place before the algorithm section began."""
        return Env(self.context, self.locals, self.size, self.depth, {}, self.at_event)

    def with_connecting(self) -> Env:
        """The same place inside `connect`."""
        return Env(
            self.context, self.locals, self.size, self.depth, self.current, self.at_event, connecting=True
        )


class Instances(Protocol):
    """The builder of the instance tree."""

    def member(self, instance: Instance, name: str) -> Member | None:
        """The member `name`, built now if need be; None if the class has no such component."""
        ...

    def package(self, scope: Scope) -> Instance:
        """The holder of a package's constants."""
        ...

    def simple_type(self, scope: Scope) -> SimpleType | None:
        """What a class boils down to if it is a predefined type, an enumeration, or derived from one."""
        ...

    def check_redeclared(self, scope: Scope) -> None:
        """A redeclared class must be compatible with its constraining class."""
        ...

    def size_so_far(self, instance: Instance, name: str, dimension: int) -> int | None:
        """A size of an array whose later sizes are still being evaluated."""
        ...


class Translation(Protocol):
    """The one evaluator of expressions of a compilation."""

    @property
    def instances(self) -> Instances: ...

    @property
    def declared_units(self) -> dict[Expr, str]:
        """Results of functions, with the unit that their output declares."""
        ...

    @property
    def warnings(self) -> list[Diagnostic]:
        """What was noticed so far that is no error."""
        ...

    def network(self, span: Span) -> Network:
        """The connections of the model as a whole. Raises while the model is still being built."""
        ...

    @property
    def formals(self) -> dict[Scope, tuple[Formal, ...]]:
        """The inputs of the functions of operators met so far."""
        ...

    def call(self, scope: Scope, node: ast.Call, env: Env) -> list[AnyValue]:
        """All outputs of a call of the function `scope`, whatever name stands in the call."""
        ...

    def value(self, node: ast.Expression, env: Env) -> AnyValue:
        """The symbolic value of an expression."""
        ...

    def evaluate(self, expression: ast.Expression, context: Context, purpose: str) -> Constant:
        """The value of a scalar expression at compile time; the text says what it is needed for."""
        ...

    def evaluate_in(self, expression: ast.Expression, env: Env, purpose: str) -> Constant:
        """As `evaluate`, where there are local names."""
        ...

    def evaluate_expr(self, item: Expr, span: Span, purpose: str) -> Constant:
        """As `evaluate`, for a translated scalar."""
        ...

    def known(self, item: Expr) -> Constant | None:
        """The value of a scalar that depends on parameters only, which become structural; else None."""
        ...

    @property
    def externals(self) -> Externals:
        """External objects and files."""
        ...

    def decide(self, condition: Expr) -> bool | None:
        """The value of a condition on parameters, which become structural; None for any other."""
        ...

    def decide_discrete(self, condition: Expr) -> bool | None:
        """As `decide`, if the condition depends on Integer, Boolean and enumeration parameters only."""
        ...

    def results(self, node: ast.Call, env: Env) -> list[AnyValue]:
        """All outputs of a function call, in order."""
        ...

    def binding_value(self, binding: Binding) -> AnyValue:
        """The value of a modification, or the part of it that falls to one element."""
        ...

    def constant_of(self, leaf: Leaf) -> Constant:
        """The value of a package's constant."""
        ...

    def enumerated(self, node: ast.Expression, env: Env) -> list[Value] | None:
        """The values of a type that can be a dimension or a range (`Boolean`, an enumeration); else None."""
        ...

    @property
    def assertions(self) -> list[Assertion]:
        """Those of the functions called so far, for whoever knows when they are called to guard them."""
        ...

    @property
    def left_limits(self) -> dict[str, Span]:
        """Real variables under `pre` outside when-clauses: they must turn out to be discrete."""
        ...

    def leaf(self, path: str) -> Leaf | None:
        """The scalar of this name, if an expression named it."""
        ...

    def note(self, leaf: Leaf) -> None:
        """Remember a scalar that an expression names."""
        ...

    def count_work(self, amount: int, span: Span) -> None:
        """Count elements that are computed. Raises when they are too many."""
        ...

    def counted(self, value: _V, span: Span) -> _V:
        """A value, its elements counted as those of another array."""
        ...

    def turns(self, values: Sequence[_T], span: Span) -> Iterator[_T]:
        """The turns of a loop, counted. Raises when they are too much."""
        ...

    def count_step(self, function: str, span: Span, *, call: bool = False) -> None:
        """Count a statement run at compile time. Raises when there are too many."""
        ...
