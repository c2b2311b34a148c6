"""parse -> print -> parse is the identity, on every tree and on the Modelica Standard Library."""

from __future__ import annotations

import os
from collections.abc import Iterator
from dataclasses import fields, is_dataclass
from pathlib import Path

import pytest
from hypothesis import HealthCheck, example, given, settings
from hypothesis.strategies import SearchStrategy

from acausal.errors import Source
from acausal.lang import ast
from acausal.lang.lexer import decode
from acausal.lang.nesting import stack_room
from acausal.lang.parser import parse, parse_expression
from acausal.lang.printer import print_class, print_definition, print_expression
from tests.lang import generators
from tests.lang.generators import SPAN

# The fixture that isolates the tests takes MODELICAPATH away, so it is read when this file is collected.
MODELICAPATH = [Path(part) for part in os.environ.get("MODELICAPATH", "").split(os.pathsep) if part]


def walk(node: object) -> Iterator[object]:
    """The node and everything in it that is a node."""
    if isinstance(node, tuple):
        for item in node:  # pyright: ignore[reportUnknownVariableType]
            yield from walk(item)  # pyright: ignore[reportUnknownArgumentType]
    elif is_dataclass(node) and node != SPAN:
        yield node
        for item in fields(node):
            yield from walk(getattr(node, item.name))


def reparsed(text: str) -> ast.StoredDefinition:
    return parse(Source("printed", text))


@given(generators.expressions)
@example(ast.RealLiteral(5e-324, SPAN))
@example(ast.RealLiteral(1e22, SPAN))
@example(ast.RealLiteral(1.7976931348623157e308, SPAN))
@example(ast.IntegerLiteral(2**63 - 1, SPAN))
@example(ast.StringLiteral('\\"\n\t\r\a\b\f\v?', SPAN))
@settings(max_examples=500, suppress_health_check=[HealthCheck.too_slow])
def test_expression_round_trip(tree: ast.Expression) -> None:
    text = print_expression(tree)
    assert parse_expression(Source("printed", text)) == tree


@given(generators.definitions)
@settings(max_examples=100, suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large])
def test_definition_round_trip(tree: ast.StoredDefinition) -> None:
    text = print_definition(tree)
    again = reparsed(text)
    assert again == tree
    assert print_definition(again) == text


def test_the_generators_make_every_node() -> None:
    """Each kind of generator is asked on its own: rare nodes do not depend on the luck of one big draw."""
    missing = set(generators.ALL_NODES)
    for strategy in (
        generators.any_node,
        generators.simple_statements,
        generators.statements,
        generators.simple_equations,
        generators.equations,
        generators.expressions,
        generators.arguments,
        generators.breaks,
        generators.classes,
    ):
        if missing:
            missing -= _made_by(strategy)
    assert not missing


def _made_by(strategy: SearchStrategy[object]) -> set[type]:
    made: set[type] = set()

    @given(strategy)
    @settings(
        max_examples=150,
        derandomize=True,
        database=None,
        suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large],
    )
    def collect(tree: object) -> None:
        made.update(type(node) for node in walk(tree))

    collect()
    return made


@pytest.mark.parametrize(
    ("text", "printed"),
    [
        ("((a))+(b)", "a + b"),
        ("a-(b-c)", "a - (b - c)"),
        ("(a-b)-c", "a - b - c"),
        ("(a*b)/c", "a*b/c"),
        ("a*(b/c)", "a*(b/c)"),
        ("(a^b)^c", "(a^b)^c"),
        ("a^(b^c)", "a^(b^c)"),
        ("(-a)^2", "(-a)^2"),
        ("-a^2", "-a^2"),
        ("-(a*b)", "-a*b"),
        ("(-a)*b", "(-a)*b"),
        ("a*(-b)", "a*(-b)"),
        ("(-a)+b", "-a + b"),
        ("-(a+b)", "-(a + b)"),
        ("a<(-b)", "a < -b"),
        ("(a<b)==c", "(a < b) == c"),
        ("not (a and b)", "not (a and b)"),
        ("(not a) and b", "not a and b"),
        ("not (not a)", "not (not a)"),
        ("(a or b) and c", "(a or b) and c"),
        ("2 .* x", "2 .* x"),
        ("(1:3)+1", "(1:3) + 1"),
        ("1:(n+1):2*n", "1:n + 1:2*n"),
        ("(if a then b else c)+1", "(if a then b else c) + 1"),
        ("if a then b elseif c then d else e", "if a then b elseif c then d else e"),
        ("if a then b else if c then d else e", "if a then b else if c then d else e"),
        ("{(a),(b,c)}", "{a, (b, c)}"),
        ("[a,b;c,d]", "[a, b; c, d]"),
        ("sum(x[i]for i in 1:n,j)", "sum(x[i] for i in 1:n, j)"),
        ("f(function g(a=1),b=2)", "f(function g(a = 1), b = 2)"),
        (".a[1,:,end].b", ".a[1, :, end].b"),
        ("1.", "1.0"),
        (".5e-3", "0.0005"),
        ("(,)", "(, )"),
    ],
)
def test_parentheses_are_minimal(text: str, printed: str) -> None:
    tree = parse_expression(Source("given", text))
    assert print_expression(tree) == printed
    assert parse_expression(Source("printed", printed)) == tree


def test_classes_are_laid_out_in_the_usual_way() -> None:
    text = """\
within A.B;
partial model M "a model"
  import SI = Modelica.Units.SI;
  extends Base(final n = 3, redeclare package Medium = Water);
  parameter SI.Length l(min = 0) = 1.5 "length" annotation(Dialog(group = "Geometry"));
  replaceable Resistor r constrainedby OnePort;
protected
  Real x[n](each start = 0), y if n > 3;
public
  flow Real f;
  type E = enumeration(a "first", b);
initial equation
  x = zeros(n);
equation
  connect(a.p, b.n) annotation(Line(points = {{0, 0}, {10, -10}}));
  if n > 3 then
    der(x) = -x;
  elseif n > 2 then
    for i in 1:n loop
      der(x[i]) = f(x, i = 3);
    end for;
  else
    (a, , b) = f(x);
  end if;
algorithm
  when {initial(), y > 0} then
    (a, b) := g(x);
    while a loop
      break;
    end while;
  end when;
  annotation(Icon(graphics = {Rectangle(extent = {{-100, -100}, {100, 100}})}));
end M;
"""
    assert print_definition(reparsed(text)) == text


def test_one_class_is_printed_without_its_semicolon() -> None:
    definition = reparsed("package P model M Real x; end M; end P;").classes[0][1]
    assert print_class(definition) == "package P\n  model M\n    Real x;\n  end M;\nend P"


def test_long_modifications_are_spread_over_lines() -> None:
    arguments = ", ".join(f"argument{i}(start = {i}, fixed = true)" for i in range(8))
    text = print_definition(reparsed(f"model M A a({arguments}); end M;"))
    assert text.splitlines()[1:3] == ["  A a(", "    argument0(start = 0, fixed = true),"]
    assert max(len(line) for line in text.splitlines()) <= 100


def test_printing_nested_long_modifications_takes_no_exponential_time() -> None:
    text = "model M A a" + "(aaaaaaaaaaaaaaaaaaaa" * 200 + " = 1" + ")" * 200 + "; end M;"
    tree = reparsed(text)
    with stack_room():
        assert reparsed(print_definition(tree)) == tree


def test_infinity_and_nan_have_no_literal() -> None:
    with pytest.raises(ValueError, match="no literal"):
        print_expression(ast.RealLiteral(float("inf"), SPAN))


def test_subscripted_parentheses_of_base_modelica_are_printed() -> None:
    one = ast.IntegerLiteral(1, SPAN)
    tree = ast.Subscripted(ast.Binary("+", one, one, SPAN), ast.Subscripts((one,), SPAN), SPAN)
    assert print_expression(tree) == "(1 + 1)[1]"


@pytest.mark.msl
@pytest.mark.slow
@pytest.mark.skipif(not MODELICAPATH, reason="MODELICAPATH does not name the Modelica Standard Library")
def test_library_round_trip() -> None:
    files = sorted(path for root in MODELICAPATH for path in root.rglob("*.mo"))
    assert files, f"no .mo file under {MODELICAPATH}"
    for path in files:
        tree = parse(decode(path.read_bytes(), str(path)))
        assert reparsed(print_definition(tree)).classes == tree.classes, path
