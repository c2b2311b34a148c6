"""The variables of a running function: declared, sized, checked, and their initial values (12.4.4)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from math import prod

from acausal.errors import AcausalError, Span
from acausal.lang import ast
from acausal.lang.arithmetic import as_value, type_error
from acausal.lang.assertions import guard_assertions
from acausal.lang.class_table import ComponentEntry
from acausal.lang.flat import Termination
from acausal.lang.instance import Instance
from acausal.lang.modifiers import Context
from acausal.lang.naming import references_in
from acausal.lang.parameter_errors import too_many_steps
from acausal.lang.scope import Scope
from acausal.lang.simple_types import SimpleType
from acausal.lang.translation import Env, Translation
from acausal.lang.values import AnyValue, RecordArray, RecordValue, Value, assignable, describe, zero_of
from acausal.symbolic.expressions import expr as ex
from acausal.symbolic.expressions.expr import Expr

MAX_STEPS = 10_000
"""Statements that one run of an algorithm section may take: what it makes of them are equations."""
_MAX_ELEMENTS = 200_000
_MAX_LEVELS = 50


@dataclass(slots=True)
class Frame:
    """A running function or algorithm section: its variables and what they were declared as.

    An algorithm section belongs to an `instance`; `current` has the values of the component's variables that
    it assigns, and `variables` its iterators only.
    """

    translation: Translation
    scope: Scope
    variables: dict[str, AnyValue]
    assigned: set[str]
    depth: int
    instance: Instance | None = None
    current: dict[Expr, Expr] = field(default_factory=dict[Expr, Expr])
    path: tuple[Expr, ...] = ()
    """The conditions under which the running statement is reached."""
    at_event: bool = False
    """In a when-statement or an initial algorithm."""
    initial: bool = False
    """In an initial algorithm, which may determine parameters."""
    terminations: list[tuple[Expr, Termination]] = field(default_factory=list[tuple[Expr, Termination]])
    """Calls of `terminate` with the condition under which each is reached."""
    tests: set[Expr] = field(default_factory=set[Expr])
    """Conditions on which values were merged."""
    steps: int = 0
    body: Scope | None = None
    """The class that the running algorithm is written in, where that is one the function inherits from."""
    owner: Instance | None = None
    """The component whose class, or one it inherits from, has the function."""

    @property
    def entries(self) -> dict[str, ComponentEntry]:
        return self.scope.table.components

    @property
    def component(self) -> str:
        """The path of the component whose algorithm section this is."""
        return "" if self.instance is None else self.instance.path

    def count_step(self, span: Span) -> None:
        """Count a statement. Raises `function.too-long`."""
        self.steps += 1
        if self.instance is None:
            self.translation.count_step(self.scope.path, span)
        elif self.steps > MAX_STEPS:
            raise too_many_steps(self.scope.path, MAX_STEPS, span)

    @property
    def guard(self) -> Expr:
        """The condition under which the running statement is reached."""
        return ex.logical_and(*self.path)

    def env(self, written: Scope | None = None) -> Env:
        """Where the expressions are translated now; `written` is the class whose text they are in."""
        context = Context(written or self.body or self.scope, self.instance)
        env = Env(context, self.variables, None, self.depth, self.current, self.at_event)
        return env if self.owner is None else env.owned_by(self.owner)

    def value(self, node: ast.Expression) -> AnyValue:
        """The value of an expression here; assertions of the functions it calls hold where it is reached."""
        found = self.translation.assertions
        start = len(found)
        value = self.translation.value(node, self.env())
        if self.path:
            guard_assertions(found, start, self.guard)
        return value

    def results(self, call: ast.Call) -> list[AnyValue]:
        """All results of a call here, as `value`."""
        found = self.translation.assertions
        start = len(found)
        values = self.translation.results(call, self.env())
        if self.path:
            guard_assertions(found, start, self.guard)
        return values


def new_frame(translation: Translation, scope: Scope, env: Env) -> Frame:
    """The frame of a call from `env`, without variables."""
    owner = env.owner or env.context.instance
    return Frame(translation, scope, {}, set(), env.depth + 1, at_event=env.at_event, owner=owner)


def default_of(entry: ComponentEntry) -> ast.Expression | None:
    """The value in a declaration, or in the modification of an `extends` clause that inherits it."""
    for outer in entry.through:
        if outer.binding is not None:
            return outer.binding.expression
    modification = entry.declaration.modification
    value = None if modification is None else modification.value
    return None if isinstance(value, ast.Break) else value


def has_value(entry: ComponentEntry) -> bool:
    """Whether a declaration gives the variable, or fields of it, a value."""
    return default_of(entry) is not None or any(c.binding is not None for c in entry.own.children.values())


def _default_env(frame: Frame, entry: ComponentEntry) -> Env:
    """Where the default value was written; the function's variables are visible there."""
    for outer in entry.through:
        if outer.binding is not None:
            return Env(_written(outer.binding.context, frame.owner), frame.variables, None, frame.depth)
    return frame.env(entry.scope)


def _written(context: Context, owner: Instance | None) -> Context:
    """A modification in a class knows what is in it: in the component that holds the function (5.3.2)."""
    while owner is not None and context.instance is None:
        if context.scope.node in owner.scope.table.lineage:
            return Context(context.scope, owner)
        owner = owner.parent
    return context


def declare(frame: Frame, entry: ComponentEntry, value: AnyValue | None, span: Span) -> AnyValue:
    """The first value of a function variable or record field, checked against its declaration.

    Unassigned variables start as zeros of their declared size, so that element-wise assignment works.
    """
    type_scope = entry.scope.find_class(entry.clause.type)
    if type_scope.kind == "function" and value is not None:
        if isinstance(value, Value) and value.type.external:
            return value
        message = f"`{entry.name}` of `{frame.scope.path}` is a function, so its argument must be one"
        raise type_error("call.function-argument", message, span, "", (entry.name,))
    simple = frame.translation.instances.simple_type(type_scope)
    if value is None:
        default = default_of(entry)
        if default is not None:
            value = frame.translation.value(default, _default_env(frame, entry))
    if value is not None:
        frame.variables[entry.name] = value  # its sizes may name itself: `A[:, size(A, 1)]`
    shape = _declared_shape(frame, entry, simple)
    if value is None:
        return _empty(frame, entry, type_scope, [n or 0 for n in shape])
    _check_shape(frame, entry, shape, value, span)
    if simple is None:
        if isinstance(value, Value):
            raise _wrong_type(frame, entry, type_scope.path, value, span)
        return value
    plain = as_value(value, span)
    if not assignable(plain.type, simple.scalar):
        raise _wrong_type(frame, entry, simple.scalar.name, plain, span)
    return Value(simple.scalar, plain.shape, plain.items)


def _wrong_type(
    frame: Frame, entry: ComponentEntry, wanted: str, value: AnyValue, span: Span
) -> AcausalError:
    message = f"`{entry.name}` of `{frame.scope.path}` is {wanted}, but it is given {describe(value)}"
    return type_error("type.mismatch", message, span, "", (entry.name,))


def _check_shape(
    frame: Frame, entry: ComponentEntry, shape: list[int | None], value: AnyValue, span: Span
) -> None:
    found = () if isinstance(value, RecordValue) else value.shape
    fits = len(shape) == len(found) and all(
        want is None or want == size for want, size in zip(shape, found, strict=True)
    )
    if not fits:
        sizes = ", ".join(":" if n is None else str(n) for n in shape)
        wanted = f"has the size [{sizes}]" if shape else "is a scalar"
        message = f"`{entry.name}` of `{frame.scope.path}` {wanted}, but it is given {describe(value)}"
        raise type_error("type.array-size", message, span, "", (entry.name,))


def _empty(frame: Frame, entry: ComponentEntry, type_scope: Scope, shape: list[int]) -> AnyValue:
    simple = frame.translation.instances.simple_type(type_scope)
    if prod(shape) > _MAX_ELEMENTS:
        message = f"`{entry.name}` of `{frame.scope.path}` has more than {_MAX_ELEMENTS} elements"
        raise type_error("array.bad-size", message, entry.declaration.span, "", (entry.name,))
    if simple is not None:
        return Value(simple.scalar, tuple(shape), (zero_of(simple.scalar),) * prod(shape))
    if frame.depth > _MAX_LEVELS:
        message = f"the record `{type_scope.path}` contains itself"
        raise type_error("instance.recursive", message, entry.declaration.span, "", (type_scope.path,))
    inner = Frame(frame.translation, type_scope, {}, set(), frame.depth + 1)
    given = _given_fields(frame, entry)
    for part in type_scope.table.components.values():
        value = given.get(part.name)
        inner.variables[part.name] = declare(inner, part, value, entry.declaration.span)
    record = RecordValue(type_scope.path, dict(inner.variables), type_scope)
    return RecordArray(tuple(shape), (record,) * prod(shape), type_scope) if shape else record


def _given_fields(frame: Frame, entry: ComponentEntry) -> dict[str, AnyValue]:
    """The fields that the declaration of a record variable gives values: `output R r(a = x)`."""
    children = entry.own.children
    return {
        name: frame.translation.value(child.binding.expression, frame.env(entry.scope))
        for name, child in children.items()
        if child.binding is not None
    }


def declared_rank(translation: Translation, entry: ComponentEntry) -> int:
    """The number of dimensions of a declared variable."""
    written = [entry.declaration.dimensions, entry.clause.dimensions]
    simple = translation.instances.simple_type(entry.scope.find_class(entry.clause.type))
    if simple is not None:
        written += [dimensions for dimensions, _ in simple.dimensions]
    return sum(len(d.items) for d in written if d is not None)


def _declared_shape(frame: Frame, entry: ComponentEntry, simple: SimpleType | None) -> list[int | None]:
    """Sizes, None for `:`."""
    env = frame.env(entry.scope)
    places = [(entry.declaration.dimensions, env), (entry.clause.dimensions, env)]
    if simple is not None:
        places += [(dimensions, Env(Context(scope, None))) for dimensions, scope in simple.dimensions]
    return [
        None if isinstance(item, ast.Colon) else _size(frame, entry, item, where)
        for dimensions, where in places
        for item in (() if dimensions is None else dimensions.items)
    ]


def _size(frame: Frame, entry: ComponentEntry, item: ast.Expression, env: Env) -> int:
    values = frame.translation.enumerated(item, env)
    if values is not None:
        return len(values)
    size = frame.translation.evaluate_in(item, env, f"the size of `{entry.name}`")
    if not isinstance(size, int) or isinstance(size, bool) or size < 0:
        message = f"the size of `{entry.name}` is {size}; it must be an Integer from 0"
        raise type_error("array.bad-size", message, item.span, "", (entry.name,))
    return size


# --------------------------------------------------------------------------- order of declarations


def declaration_order(entries: Iterable[ComponentEntry]) -> list[ComponentEntry]:
    """The variables so that each comes after those its size and default value name; else as written."""
    by_name = {entry.name: entry for entry in entries}
    order: dict[str, ComponentEntry] = {}
    busy: set[str] = set()

    def visit(entry: ComponentEntry) -> None:
        if entry.name in order or entry.name in busy:
            return
        busy.add(entry.name)
        for name in _names_in(entry):
            if name in by_name:
                visit(by_name[name])
        order[entry.name] = entry

    for entry in by_name.values():
        visit(entry)
    return list(order.values())


def _names_in(entry: ComponentEntry) -> Iterator[str]:
    """First identifiers of the references in a declaration's sizes and value."""
    roots = (default_of(entry), entry.clause.dimensions, entry.declaration.dimensions)
    return (reference.parts[0].name for reference in references_in(*roots))
