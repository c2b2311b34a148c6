"""Hypothesis strategies for arbitrary syntax trees: exactly those that some valid text parses to."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar, cast

from hypothesis import strategies as st
from hypothesis.strategies import SearchStrategy, builds, just, lists, none, one_of, sampled_from

from acausal.errors import Source, Span
from acausal.lang import ast
from acausal.lang.lexer import KEYWORDS, LARGEST_INTEGER
from acausal.lang.operators import BINARY_LEVELS, PREFIX_LEVELS
from acausal.lang.syntax_errors import PREDEFINED

T = TypeVar("T")
Expressions = SearchStrategy[ast.Expression]

SPAN = Span(Source("generated", ""), 0, 0)
NO_COMMENT = ast.Comment(None, None)
NO_PREFIXES = ast.Prefixes()
span = just(SPAN)
flag = st.booleans()


def tuples_of(items: SearchStrategy[T], least: int = 0, most: int = 3) -> SearchStrategy[tuple[T, ...]]:
    def as_tuple(values: list[T]) -> tuple[T, ...]:
        return tuple(values)

    return lists(items, min_size=least, max_size=most).map(as_tuple)


def maybe(items: SearchStrategy[T]) -> SearchStrategy[T | None]:
    return one_of(none(), items)


def opaque(items: SearchStrategy[T]) -> SearchStrategy[T]:
    """The same strategy with a short `repr`: those of nested ones grow exponentially."""
    return st.deferred(lambda: items)


# --------------------------------------------------------------------------- names and literals

_QUOTED_CHARACTERS = [chr(c) for c in range(0x20, 0x7F) if chr(c) not in "'\\"] + [
    r"\'",
    r"\\",
    r"\a",
    r"\n",
    r"\v",
]

plain_names = st.from_regex(r"[A-Za-z_][A-Za-z0-9_]{0,5}", fullmatch=True).filter(
    lambda name: name not in KEYWORDS and name not in PREDEFINED
)
quoted_names = lists(sampled_from(_QUOTED_CHARACTERS), max_size=5).map(
    lambda parts: "'" + "".join(parts) + "'"
)
names = opaque(one_of(sampled_from(("a", "b", "x1", "_", "e1", "E")), plain_names, quoted_names))

dotted = opaque(tuples_of(names, 1))

texts = opaque(
    one_of(
        st.text(max_size=8, alphabet=st.characters(exclude_characters="\0", exclude_categories=("Cs",))),
        st.text(max_size=8, alphabet="\\\"'\n\t\r\a\b\f\v?/*+na"),
    )
)


def _one_name(name: str) -> ast.ComponentReference:
    return ast.ComponentReference((ast.NamePart(name, None, SPAN),), False, SPAN)


def _plain_parts(parts: tuple[str, ...], global_: bool) -> ast.ComponentReference:
    return ast.ComponentReference(tuple(ast.NamePart(part, None, SPAN) for part in parts), global_, SPAN)


types = opaque(one_of(sampled_from(("Real", "Integer")).map(_one_name), builds(_plain_parts, dotted, flag)))

leaves: Expressions = opaque(
    one_of(
        builds(ast.RealLiteral, st.floats(0, allow_infinity=False, allow_nan=False), span),
        builds(ast.IntegerLiteral, st.integers(0, LARGEST_INTEGER), span),
        builds(ast.BooleanLiteral, flag, span),
        builds(ast.StringLiteral, texts, span),
        builds(_plain_parts, dotted, flag),
    )
)

# --------------------------------------------------------------------------- expressions


def subscripts(items: Expressions) -> SearchStrategy[ast.Subscripts]:
    return builds(ast.Subscripts, tuples_of(one_of(items, builds(ast.Colon, span)), 1, 2), span)


def references(subscript: Expressions) -> SearchStrategy[ast.ComponentReference]:
    part = builds(ast.NamePart, names, maybe(subscripts(subscript)), span)
    return builds(ast.ComponentReference, tuples_of(part, 1), flag, span)


def iterators(items: Expressions, least: int = 1) -> SearchStrategy[tuple[ast.Iterator, ...]]:
    return tuples_of(builds(ast.Iterator, names, maybe(items), span), least, 2)


def calls(items: Expressions, functions: SearchStrategy[ast.ComponentReference]) -> SearchStrategy[ast.Call]:
    partial_names = tuples_of(builds(ast.NamedArgument, names, items, span), 0, 2)
    argument = one_of(items, builds(ast.PartialFunction, types, partial_names, span))
    named = tuples_of(builds(ast.NamedArgument, names, argument, span), 0, 2)
    plain = builds(ast.Call, functions, tuples_of(argument), named, just(()), span)
    return one_of(
        plain, builds(ast.Call, functions, tuples_of(items, 1, 1), just(()), iterators(items), span)
    )


def tuple_expressions(items: Expressions, singles: bool) -> SearchStrategy[ast.Tuple]:
    several = tuples_of(maybe(items), 2)
    forms = [just(()), several, *([tuples_of(items, 1, 1)] if singles else [])]
    return builds(ast.Tuple, cast("SearchStrategy[tuple[ast.Expression | None, ...]]", one_of(*forms)), span)


def _operations(items: Expressions) -> Expressions:
    unary = cast("list[ast.UnaryOperator]", list(PREFIX_LEVELS))
    binary = cast("list[ast.BinaryOperator]", list(BINARY_LEVELS))
    return one_of(
        builds(ast.Unary, sampled_from(unary), items, span),
        builds(ast.Binary, sampled_from(binary), items, items, span),
        builds(ast.If, tuples_of(st.tuples(items, items), 1, 2), items, span),
        builds(ast.Range, items, maybe(items), items, span),
    )


def _compounds(items: Expressions, subscript: Expressions) -> Expressions:
    keyword_functions = sampled_from(("der", "initial", "pure")).map(_one_name)
    return one_of(
        _operations(items),
        references(subscript),
        calls(items, one_of(references(subscript), keyword_functions)),
        builds(ast.ArrayConstructor, tuples_of(items, 1), just(()), span),
        builds(ast.ArrayConstructor, tuples_of(items, 1, 1), iterators(items), span),
        builds(ast.Matrix, tuples_of(tuples_of(items, 1), 1, 2), span),
        tuple_expressions(items, singles=False),
    )


_ends: Expressions = builds(ast.End, span)
inside_subscripts: Expressions = opaque(
    st.recursive(one_of(leaves, _ends), lambda items: _compounds(items, items), max_leaves=6)
)

expressions: Expressions = opaque(
    st.recursive(leaves, lambda items: _compounds(items, inside_subscripts), max_leaves=12)
)

small: Expressions = opaque(one_of(leaves, st.recursive(leaves, _operations, max_leaves=4)))

# --------------------------------------------------------------------------- modifications

ElementModifications = SearchStrategy[ast.Argument]


def _annotations(arguments: SearchStrategy[tuple[ast.Argument, ...]]) -> SearchStrategy[ast.Annotation]:
    return builds(ast.Annotation, arguments, span)


def _value(arguments: tuple[ast.Argument, ...], value: ast.Expression | ast.Break | None) -> ast.Modification:
    return ast.Modification(arguments, value, SPAN)


def modifications(arguments: ElementModifications) -> SearchStrategy[ast.Modification]:
    values = one_of(small, builds(ast.Break, span), none())
    return builds(_value, tuples_of(arguments), values)


def class_modifications(arguments: ElementModifications) -> SearchStrategy[ast.Modification]:
    return builds(ast.Modification, tuples_of(arguments), none(), span)


def comments(arguments: ElementModifications) -> SearchStrategy[ast.Comment]:
    return builds(ast.Comment, maybe(texts), maybe(_annotations(tuples_of(arguments, 0, 2))))


def constraints(
    arguments: ElementModifications, comment: SearchStrategy[ast.Comment]
) -> SearchStrategy[ast.Constraint]:
    return builds(ast.Constraint, types, maybe(class_modifications(arguments)), comment, span)


def declarations(
    arguments: ElementModifications, conditions: SearchStrategy[ast.Expression | None]
) -> SearchStrategy[ast.Declaration]:
    dimensions = maybe(subscripts(small))
    return builds(
        ast.Declaration,
        names,
        dimensions,
        maybe(modifications(arguments)),
        conditions,
        comments(arguments),
        span,
    )


def clauses(
    arguments: ElementModifications,
    prefixes: SearchStrategy[ast.Prefixes],
    dimensions: SearchStrategy[ast.Subscripts | None],
    declared: SearchStrategy[tuple[ast.Declaration, ...]],
) -> SearchStrategy[ast.ComponentClause]:
    return builds(
        ast.ComponentClause,
        prefixes,
        sampled_from(cast("list[ast.Flow]", ["", "", "flow", "stream"])),
        sampled_from(cast("list[ast.Variability]", ["", "", "discrete", "parameter", "constant"])),
        sampled_from(cast("list[ast.Causality]", ["", "", "input", "output"])),
        types,
        dimensions,
        declared,
        none(),
        span,
    )


_KINDS: list[ast.ClassKind] = [
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


@st.composite
def class_words(draw: st.DrawFn, encapsulated: bool) -> tuple[ast.ClassKind, ast.ClassPrefixes]:
    """A kind of class with prefixes that go with it."""
    kind = draw(sampled_from(_KINDS))
    prefixes = ast.ClassPrefixes(
        encapsulated=encapsulated and draw(flag),
        partial=draw(flag),
        expandable=kind == "connector" and draw(flag),
        operator=kind in ("record", "function") and draw(flag),
        purity=draw(sampled_from(cast("list[ast.Purity]", ["", "pure", "impure"])))
        if kind == "function"
        else "",
    )
    return kind, prefixes


@st.composite
def short_classes(
    draw: st.DrawFn, arguments: ElementModifications, prefixes: ast.Prefixes, encapsulated: bool
) -> ast.ShortClass | ast.EnumerationClass:
    """`type T = ...` of either form, without a constraint."""
    kind, words = draw(class_words(encapsulated))
    name, comment = draw(names), draw(comments(arguments))
    if draw(flag):
        literal = builds(ast.EnumerationLiteral, names, comments(arguments), span)
        literals = draw(maybe(tuples_of(literal)))
        return ast.EnumerationClass(name, kind, words, prefixes, literals, comment, None, SPAN)
    causality = draw(sampled_from(cast("list[ast.Causality]", ["", "input", "output"])))
    dimensions = draw(maybe(subscripts(small)))
    modification = draw(maybe(class_modifications(arguments)))
    base = draw(types)
    return ast.ShortClass(
        name, kind, words, prefixes, causality, base, dimensions, modification, comment, None, SPAN
    )


@st.composite
def redeclarations(draw: st.DrawFn, arguments: ElementModifications) -> ast.ElementRedeclaration:
    """`redeclare ...` or `replaceable ...` inside a modification."""
    redeclare = draw(flag)
    replaceable = not redeclare or draw(flag)
    component = clauses(
        arguments, just(NO_PREFIXES), none(), tuples_of(declarations(arguments, none()), 1, 1)
    )
    element = draw(one_of(component, short_classes(arguments, NO_PREFIXES, False)))
    constraint = draw(maybe(constraints(arguments, just(NO_COMMENT)))) if replaceable else None
    return ast.ElementRedeclaration(element, redeclare, draw(flag), draw(flag), replaceable, constraint, SPAN)


def _more_arguments(items: ElementModifications) -> ElementModifications:
    return one_of(_element_modifications(modifications(items)), redeclarations(items))


def _element_modifications(values: SearchStrategy[ast.Modification]) -> ElementModifications:
    comment = builds(ast.Comment, maybe(texts), none())
    return builds(ast.ElementModification, dotted, maybe(values), flag, flag, comment, span)


_values_only = builds(ast.Modification, just(()), small, span)
arguments: ElementModifications = opaque(
    st.recursive(_element_modifications(_values_only), _more_arguments, max_leaves=3)
)

breaks: ElementModifications = opaque(
    one_of(
        builds(ast.BreakConnect, none(), names, span),
        builds(
            ast.BreakConnect,
            builds(ast.ConnectEquation, references(small), references(small), just(NO_COMMENT), span),
            none(),
            span,
        ),
    )
)

# --------------------------------------------------------------------------- equations and statements

_comments = opaque(comments(arguments))

_user_calls = opaque(calls(expressions, references(inside_subscripts)))

simple_equations: SearchStrategy[ast.Equation] = opaque(
    one_of(
        builds(ast.EqualEquation, expressions, expressions, _comments, span),
        builds(ast.ConnectEquation, references(small), references(small), _comments, span),
        builds(ast.CallEquation, _user_calls, _comments, span),
    )
)


def _branches(body: SearchStrategy[T]) -> SearchStrategy[tuple[tuple[ast.Expression, tuple[T, ...]], ...]]:
    return tuples_of(st.tuples(small, tuples_of(body, 0, 2)), 1, 2)


def _equation_blocks(items: SearchStrategy[ast.Equation]) -> SearchStrategy[ast.Equation]:
    body = tuples_of(items, 0, 2)
    return one_of(
        builds(ast.IfEquation, _branches(items), body, _comments, span),
        builds(ast.ForEquation, iterators(small), body, _comments, span),
        builds(ast.WhenEquation, _branches(items), _comments, span),
    )


equations = opaque(st.recursive(simple_equations, _equation_blocks, max_leaves=4))

simple_statements: SearchStrategy[ast.Statement] = opaque(
    one_of(
        builds(ast.Assignment, references(small), expressions, _comments, span),
        builds(ast.Assignment, tuple_expressions(small, singles=True), _user_calls, _comments, span),
        builds(ast.CallStatement, _user_calls, _comments, span),
        builds(ast.BreakStatement, _comments, span),
        builds(ast.ReturnStatement, _comments, span),
    )
)


def _statement_blocks(items: SearchStrategy[ast.Statement]) -> SearchStrategy[ast.Statement]:
    body = tuples_of(items, 0, 2)
    return one_of(
        builds(ast.IfStatement, _branches(items), body, _comments, span),
        builds(ast.ForStatement, iterators(small), body, _comments, span),
        builds(ast.WhileStatement, small, body, _comments, span),
        builds(ast.WhenStatement, _branches(items), _comments, span),
    )


statements = opaque(st.recursive(simple_statements, _statement_blocks, max_leaves=4))

# --------------------------------------------------------------------------- classes


@st.composite
def imports(draw: st.DrawFn) -> ast.Import:
    """Any of the four forms of an import."""
    form = draw(sampled_from(("plain", "alias", "wildcard", "group")))
    return ast.Import(
        draw(dotted),
        draw(names) if form == "alias" else None,
        form == "wildcard",
        draw(tuples_of(names, 1)) if form == "group" else (),
        draw(_comments),
        SPAN,
    )


@st.composite
def element_prefixes(draw: st.DrawFn) -> ast.Prefixes:
    """Any combination: the grammar allows all of them."""
    return ast.Prefixes(*[draw(flag) for _ in range(6)])


extends_clauses = opaque(
    builds(
        ast.Extends,
        types,
        maybe(class_modifications(one_of(arguments, breaks))),
        maybe(_annotations(tuples_of(arguments, 0, 2))),
        flag,
        span,
    )
)


@st.composite
def components(draw: st.DrawFn) -> ast.ComponentClause:
    """A component clause as an element of a class."""
    prefixes = draw(element_prefixes())
    declared = tuples_of(declarations(arguments, maybe(small)), 1, 2)
    clause = draw(clauses(arguments, just(prefixes), maybe(subscripts(small)), declared))
    constraint = draw(maybe(constraints(arguments, _comments))) if prefixes.replaceable else None
    return ast.ComponentClause(
        clause.prefixes,
        clause.flow,
        clause.variability,
        clause.causality,
        clause.type,
        clause.dimensions,
        clause.declarations,
        constraint,
        SPAN,
    )


@st.composite
def external_clauses(draw: st.DrawFn) -> ast.External:
    """`external`, with or without a call."""
    name = draw(maybe(names))
    called = name is not None
    return ast.External(
        draw(maybe(texts)),
        draw(maybe(references(small))) if called else None,
        name,
        draw(tuples_of(expressions)) if called else (),
        draw(maybe(_annotations(tuples_of(arguments, 0, 2)))),
        SPAN,
    )


_sections: SearchStrategy[ast.EquationSection | ast.AlgorithmSection] = opaque(
    one_of(
        builds(ast.EquationSection, tuples_of(equations, 0, 2), flag, span),
        builds(ast.AlgorithmSection, tuples_of(statements, 0, 2), flag, span),
    )
)


def _compositions(elements: SearchStrategy[ast.Element]) -> SearchStrategy[ast.Composition]:
    return builds(
        ast.Composition,
        tuples_of(elements),
        tuples_of(_sections, 0, 2),
        maybe(external_clauses()),
        maybe(_annotations(tuples_of(arguments, 0, 2))),
    )


@st.composite
def class_definitions(
    draw: st.DrawFn, prefixes: SearchStrategy[ast.Prefixes], elements: SearchStrategy[ast.Element]
) -> ast.ClassDefinition:
    """A class of any of the four forms."""
    element_words = draw(prefixes)
    constraint = draw(maybe(constraints(arguments, _comments))) if element_words.replaceable else None
    kind, words = draw(class_words(True))
    name = draw(names)
    form = draw(sampled_from(("long", "long", "extends", "enumeration", "short", "der")))
    if form in ("long", "extends"):
        modification = draw(maybe(class_modifications(arguments))) if form == "extends" else None
        body = draw(_compositions(elements))
        comment = draw(maybe(texts))
        extends = form == "extends"
        return ast.LongClass(
            name, kind, words, element_words, extends, modification, comment, body, constraint, SPAN
        )
    comment = draw(_comments)
    if form == "der":
        base, variables = draw(types), draw(tuples_of(names, 1))
        return ast.DerClass(name, kind, words, element_words, base, variables, comment, constraint, SPAN)
    if form == "enumeration":
        literals = draw(maybe(tuples_of(builds(ast.EnumerationLiteral, names, _comments, span))))
        return ast.EnumerationClass(name, kind, words, element_words, literals, comment, constraint, SPAN)
    short = draw(
        short_classes(arguments, element_words, True).filter(lambda item: isinstance(item, ast.ShortClass))
    )
    assert isinstance(short, ast.ShortClass)
    return ast.ShortClass(
        name,
        kind,
        words,
        element_words,
        short.causality,
        short.base,
        short.dimensions,
        short.modification,
        comment,
        constraint,
        SPAN,
    )


def _nested(items: SearchStrategy[ast.Element]) -> SearchStrategy[ast.Element]:
    return class_definitions(element_prefixes(), items)


_simple_elements: SearchStrategy[ast.Element] = opaque(one_of(imports(), extends_clauses, components()))

elements: SearchStrategy[ast.Element] = opaque(st.recursive(_simple_elements, _nested, max_leaves=4))

classes = opaque(class_definitions(just(NO_PREFIXES), elements))

definitions = builds(
    ast.StoredDefinition,
    maybe(tuples_of(names)),
    tuples_of(st.tuples(flag, classes), 1, 2),
    just("generated"),
)

any_node: SearchStrategy[object] = one_of(
    definitions, elements, extends_clauses, equations, statements, expressions, arguments
)
"""Something large or small, for looking at what the generators make."""

ALL_NODES: tuple[Callable[..., object], ...] = (
    ast.Subscripts, ast.NamePart, ast.ComponentReference, ast.RealLiteral, ast.IntegerLiteral,
    ast.BooleanLiteral, ast.StringLiteral, ast.Unary, ast.Binary, ast.If, ast.NamedArgument, ast.Iterator,
    ast.Call, ast.PartialFunction, ast.ArrayConstructor, ast.Matrix, ast.Range, ast.Tuple, ast.Colon,
    ast.End, ast.Annotation, ast.Comment, ast.Modification, ast.Break, ast.ElementModification,
    ast.ElementRedeclaration, ast.BreakConnect, ast.EqualEquation, ast.ConnectEquation, ast.CallEquation,
    ast.IfEquation, ast.ForEquation, ast.WhenEquation, ast.Assignment, ast.CallStatement, ast.IfStatement,
    ast.ForStatement, ast.WhileStatement, ast.WhenStatement, ast.BreakStatement, ast.ReturnStatement,
    ast.EquationSection, ast.AlgorithmSection, ast.External, ast.Prefixes, ast.Constraint, ast.Import,
    ast.Extends, ast.Declaration, ast.ComponentClause, ast.EnumerationLiteral, ast.Composition,
    ast.ClassPrefixes, ast.LongClass, ast.ShortClass, ast.EnumerationClass, ast.DerClass,
    ast.StoredDefinition,
)  # fmt: skip
"""Every node the parser can build (`Subscripted` belongs to Base Modelica)."""
