"""What equations and statements may stand where, by the text alone (Modelica 3.6, 8.3, 8.6, 11.2 and 12.2).

`check_sections` walks each section of a class once; names are not looked up.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import fields

from acausal.errors import AcausalError, Span, TypeProblem, fail
from acausal.lang import ast
from acausal.lang.light import light_object

_NOT_IN_FUNCTIONS = frozenset(
    "der initial terminal sample pre edge change reinit delay cardinality inStream actualStream hold".split()
    + "previous subSample superSample shiftSample backSample noClock interval firstTick".split()
    + "transition initialState activeState ticksInState timeInState".split()
)
_EXPRESSION_NODES = (
    ast.Subscripts, ast.NamePart, ast.Unary, ast.Binary, ast.If, ast.NamedArgument, ast.Iterator, ast.Call,
    ast.PartialFunction, ast.ArrayConstructor, ast.Matrix, ast.Range, ast.Tuple, ast.Subscripted,
    ast.ComponentReference,
)  # fmt: skip
_FIELDS = {kind: tuple([f.name for f in fields(kind) if f.name != "span"]) for kind in _EXPRESSION_NODES}


@light_object
class _Place:
    """Where an equation or statement stands."""

    path: str
    in_function: bool
    initial: bool
    in_when: bool = False
    in_loop: bool = False
    in_clause: bool = False
    """Inside `if`, `for`, `while` or `when`."""

    def inside(self, *, when: bool = False, loop: bool = False) -> _Place:
        return _Place(
            self.path,
            self.in_function,
            self.initial,
            self.in_when or when,
            self.in_loop or loop,
            True,
        )


def check_sections(definition: ast.LongClass, path: str) -> None:
    """Raise `equation.*`, `statement.*` or `function.*` for what stands in the wrong place."""
    in_function = definition.kind == "function"
    for section in definition.body.sections:
        place = _Place(path, in_function, section.initial)
        if isinstance(section, ast.EquationSection):
            _equations(section.equations, place)
        else:
            _statements(section.statements, place)
    if in_function:
        for element in definition.body.elements:
            if isinstance(element, ast.ComponentClause):
                _in_function([_values_of(d.modification) for d in element.declarations], path)


def check_no_time(clause: ast.ComponentClause, path: str, kind: str) -> None:
    """`time` is known in models and blocks only (3.6.7)."""
    for node in expressions_in([_values_of(declaration.modification) for declaration in clause.declarations]):
        if isinstance(node, ast.ComponentReference) and node.text == "time":
            message = f"`{path}` is a {kind} and cannot use `time`"
            raise _error("class.time", message, node.span, "3.6.7", (path, "time"))


def _values_of(modification: ast.Modification | None) -> tuple[ast.Expression, ...]:
    """All expressions in a modification."""
    if modification is None:
        return ()
    values: list[ast.Expression] = []
    if modification.value is not None and not isinstance(modification.value, ast.Break):
        values.append(modification.value)
    for argument in modification.arguments:
        if isinstance(argument, ast.ElementModification):
            values += _values_of(argument.modification)
    return tuple(values)


def _error(code: str, message: str, span: Span, section: str, names: tuple[str, ...] = ()) -> AcausalError:
    return fail(TypeProblem, code, message, span, names=names, hint=f"see Modelica 3.6, {section}")


# --------------------------------------------------------------------------- equations


def _equations(equations: Iterable[ast.Equation], place: _Place) -> None:
    for equation in equations:
        if isinstance(equation, ast.IfEquation):
            for _, body in equation.branches:
                _equations(body, place.inside())
            _equations(equation.otherwise, place.inside())
        elif isinstance(equation, ast.ForEquation):
            _equations(equation.body, place.inside())
        elif isinstance(equation, ast.WhenEquation):
            _when(equation.span, place, "equation")
            for _, body in equation.branches:
                _equations(body, place.inside(when=True))
        elif isinstance(equation, ast.ConnectEquation):
            _connect(equation, place)
        elif isinstance(equation, ast.EqualEquation):
            _equality(equation, place)
        else:
            _call(equation.call, place, "equation")


def _when(span: Span, place: _Place, what: str) -> None:
    if place.in_when:
        message = f"a when-clause cannot stand inside another one in `{place.path}`"
        raise _error(f"{what}.nested-when", message, span, "8.3.5.2 and 11.2.7.1", (place.path,))
    if place.initial:
        message = f"a when-clause cannot stand among the initial equations or algorithms of `{place.path}`"
        raise _error(f"{what}.when-in-initial", message, span, "8.6", (place.path,))
    if what == "statement" and place.in_clause:
        message = f"a when-statement cannot stand inside `if`, `for` or `while` in `{place.path}`"
        raise _error("statement.when-in-clause", message, span, "11.2.7.1", (place.path,))


def _connect(equation: ast.ConnectEquation, place: _Place) -> None:
    names = (equation.left.text, equation.right.text)
    if place.in_when:
        message = "`connect` cannot stand in `when`"
        raise _error("equation.connect-in-when", message, equation.span, "9.3", names)
    if place.initial:
        message = "`connect` cannot stand among initial equations"
        raise _error("equation.connect-in-initial", message, equation.span, "8.6", names)


def _equality(equation: ast.EqualEquation, place: _Place) -> None:
    """In `when`, only `v = expression` and `(v, w) = f(...)` (8.3.5.2)."""
    left, right = equation.left, equation.right
    if isinstance(left, ast.Tuple) and not isinstance(right, ast.Call):
        message = "a list in parentheses on the left needs a function call on the right"
        raise _error("equation.tuple", message, equation.span, "8.3.1")
    if place.in_when and not isinstance(left, (ast.ComponentReference, ast.Tuple)):
        message = "in a when-equation the left side is a variable, or a list of variables in parentheses"
        raise _error("equation.when-left-side", message, equation.left.span, "8.3.5.2")


def _call(call: ast.Call, place: _Place, what: str) -> None:
    name = call.function.text
    if name == "reinit" and not place.in_when:
        message = "`reinit` is only allowed in a when-equation"
        raise _error("equation.reinit", message, call.span, "8.3.6", (name,))
    if name == "reinit" and what == "statement":
        message = "`reinit` is only allowed in a when-equation, not in an algorithm"
        raise _error("statement.reinit", message, call.span, "8.3.6", (name,))
    if place.in_function:
        _in_function([call], place.path)


# --------------------------------------------------------------------------- statements


def _statements(statements: Iterable[ast.Statement], place: _Place) -> None:
    for statement in statements:
        _statement(statement, place)


def _statement(statement: ast.Statement, place: _Place) -> None:
    if isinstance(statement, ast.Assignment):
        if isinstance(statement.target, ast.Tuple) and not isinstance(statement.value, ast.Call):
            message = "a list in parentheses on the left needs a function call on the right"
            raise _error("statement.tuple", message, statement.span, "11.2.1.1")
        if place.in_function:
            _in_function([statement.target, statement.value], place.path)
    elif isinstance(statement, ast.IfStatement):
        _in_function_if(place, [condition for condition, _ in statement.branches])
        for _, body in statement.branches:
            _statements(body, place.inside())
        _statements(statement.otherwise, place.inside())
    elif isinstance(statement, ast.ForStatement):
        _in_function_if(place, statement.iterators)
        _statements(statement.body, place.inside(loop=True))
    elif isinstance(statement, ast.WhileStatement):
        _in_function_if(place, [statement.condition])
        _statements(statement.body, place.inside(loop=True))
    elif isinstance(statement, ast.WhenStatement):
        _when_statement(statement, place)
    elif isinstance(statement, ast.CallStatement):
        _call(statement.call, place, "statement")
    else:
        _jump(statement, place)


def _in_function_if(place: _Place, roots: Iterable[object]) -> None:
    if place.in_function:
        _in_function(roots, place.path)


def _when_statement(statement: ast.WhenStatement, place: _Place) -> None:
    if place.in_function:
        message = f"the function `{place.path}` cannot contain `when`"
        raise _error("function.when", message, statement.span, "12.2", (place.path,))
    _when(statement.span, place, "statement")
    for _, body in statement.branches:
        _statements(body, place.inside(when=True))


def _jump(statement: ast.BreakStatement | ast.ReturnStatement, place: _Place) -> None:
    if isinstance(statement, ast.ReturnStatement) and not place.in_function:
        message = f"`return` is only allowed in functions, and `{place.path}` is none"
        raise _error("statement.return", message, statement.span, "11.2.5", (place.path,))
    if isinstance(statement, ast.BreakStatement) and not place.in_loop:
        message = f"`break` stands outside a loop in `{place.path}`"
        raise _error("function.break", message, statement.span, "11.2.4", (place.path,))


# --------------------------------------------------------------------------- expressions of functions


def _in_function(roots: Iterable[object], path: str) -> None:
    """Operators and `time`, which functions cannot use (3.6.7, 12.2)."""
    for node in expressions_in(roots):
        if isinstance(node, ast.Call):
            name = node.function.text
            if name in _NOT_IN_FUNCTIONS or name.startswith("Connections."):
                message = f"the function `{path}` cannot use the operator `{name}`"
                raise _error("function.operator", message, node.span, "12.2", (path, name))
        elif isinstance(node, ast.ComponentReference) and node.text == "time" and not node.global_:
            message = f"the function `{path}` cannot use `time`"
            raise _error("function.time", message, node.span, "3.6.7", (path, "time"))


def expressions_in(roots: Iterable[object]) -> Iterator[object]:
    """All expression nodes at and below the roots. Iterative."""
    stack: list[object] = list(roots)
    while stack:
        node = stack.pop()
        if isinstance(node, tuple):
            stack.extend(node)  # pyright: ignore[reportUnknownArgumentType]  # any tuple of nodes
            continue
        if node is None:
            continue
        yield node
        names = _FIELDS.get(type(node))  # pyright: ignore[reportArgumentType]  # other nodes have no entry
        if names is not None:
            stack.extend([getattr(node, name) for name in names])
