"""What parses to which tree, what is refused with which message, and that nothing else can happen."""

from __future__ import annotations

import sys

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from acausal.errors import Diagnostic, Source, SyntaxProblem
from acausal.lang import ast
from acausal.lang.lexer import decode, tokenize
from acausal.lang.nesting import NESTING_LIMIT, stack_room
from acausal.lang.parser import parse, parse_expression
from acausal.lang.printer import print_expression


def expression(text: str) -> ast.Expression:
    return parse_expression(Source("e", text))


def tree(text: str) -> str:
    """The expression with all its parentheses."""
    return _shape(expression(text))


def _shape(e: ast.Expression) -> str:
    match e:
        case ast.Binary():
            return f"({_shape(e.left)} {e.operator} {_shape(e.right)})"
        case ast.Unary():
            return f"({e.operator} {_shape(e.operand)})"
        case ast.Range():
            parts = (e.start, e.stop) if e.step is None else (e.start, e.step, e.stop)
            return "(" + " : ".join(_shape(part) for part in parts) + ")"
        case _:
            return print_expression(e)


def refused(text: str) -> Diagnostic:
    with pytest.raises(SyntaxProblem) as caught:
        parse(Source("t.mo", text))
    (diagnostic,) = caught.value.diagnostics
    return diagnostic


def only_class(text: str) -> ast.LongClass:
    ((_, definition),) = parse(Source("t.mo", text)).classes
    assert isinstance(definition, ast.LongClass)
    return definition


# --------------------------------------------------------------------------- trees


@pytest.mark.parametrize(
    ("text", "shape"),
    [
        ("a+b*c", "(a + (b * c))"),
        ("a-b-c", "((a - b) - c)"),
        ("a/b*c", "((a / b) * c)"),
        ("a*b^c", "(a * (b ^ c))"),
        ("-a^2", "(- (a ^ 2))"),
        ("-a*b+c", "((- (a * b)) + c)"),
        ("a < -b", "(a < (- b))"),
        ("a + b < c*d", "((a + b) < (c * d))"),
        ("not a == b and c or d", "(((not (a == b)) and c) or d)"),
        ("a or b and not c", "(a or (b and (not c)))"),
        ("1:n+1", "(1 : (n + 1))"),
        ("1:2:n", "(1 : 2 : n)"),
        ("a .* b .^ c .+ d", "((a .* (b .^ c)) .+ d)"),
        (".-a", "(.- a)"),
        ("(a)", "a"),
    ],
)
def test_precedence(text: str, shape: str) -> None:
    assert tree(text) == shape


def test_end_is_an_expression_only_in_subscripts() -> None:
    assert print_expression(expression("a[f(end - 1), 2].b[end]")) == "a[f(end - 1), 2].b[end]"
    with pytest.raises(SyntaxProblem):
        expression("end")


def test_spans_are_the_text_of_the_node() -> None:
    result = expression("  (a + b) * f(x[1], y = -2)  ")
    assert isinstance(result, ast.Binary)
    assert result.span.text == "(a + b) * f(x[1], y = -2)"
    assert (result.left.span.text, result.right.span.text) == ("a + b", "f(x[1], y = -2)")
    assert result.span.column == 3


def test_elements_and_their_prefixes() -> None:
    body = only_class("""
        model M "about"
          import A = B.C;
          replaceable model X = Y(a = 1) constrainedby Z "why";
        protected
          inner parameter Real[2] p[3](each start = 1) = 2 if c "text";
        equation
        annotation(a = 1);
        end M;
    """).body
    imported, short, component = body.elements
    assert isinstance(imported, ast.Import)
    assert (imported.alias, imported.name) == ("A", ("B", "C"))
    assert isinstance(short, ast.ShortClass)
    assert short.prefixes.replaceable
    assert short.constraint is not None
    assert short.constraint.comment.text == "why"
    assert isinstance(component, ast.ComponentClause)
    assert (component.prefixes.inner, component.prefixes.protected) == (True, True)
    assert component.declarations[0].condition is not None
    assert component.declarations[0].comment.text == "text"
    assert body.sections[0].initial is False
    assert body.annotation is not None


@pytest.mark.parametrize(
    "text",
    [
        "within; model M end M;",
        "within A.B; final model M end M; type T = Real;",
        "function f = der(g, x, y);",
        "type E = enumeration(:);",
        "type E = enumeration();",
        "model M = input N[3](a = 1);",
        'model extends M(a = 1) "text" end M;',
        "impure function f external; end f;",
        'function f external "C" y[1] = g(x, 2) annotation(a = 1); annotation(b = 2); end f;',
        "model M extends A(break b, break connect(a, b), c = 1); end M;",
        "model M A a(redeclare each final replaceable Real b[2] = 1 constrainedby C, x = break); end M;",
        "model M A a(redeclare type T = enumeration(a), replaceable partial model B = C); end M;",
        "model M Real x(start := 1); Real y := 2; end M;",
        'model M import A.*; import A.B.{C, D}; import A . * "all"; end M;',
        "model M equation .A.f(x); algorithm .A.f(x); return; end M;",
        "model M equation for i loop x[i] = 1; end for; when a then elsewhen b then end when; end M;",
        "operator record C encapsulated operator function f end f; operator 'x' end 'x'; end C;",
        'model M "a" + "b" Real x "c" + "d"; end M;',
    ],
)
def test_is_accepted(text: str) -> None:
    parse(Source("t.mo", text))


# --------------------------------------------------------------------------- messages


def model(body: str) -> str:
    return f"model M\n{body}\nend M;"


@pytest.mark.parametrize(
    ("text", "code", "line", "column", "message", "hint"),
    [
        (model("Real x\nReal y;"), "missing-semicolon", 2, 7, "declaration of `x`, found `Real`", "insert"),
        (model("equation\nx = 1\ny = 2;"), "missing-semicolon", 3, 6, "equation of line 3, found `y`", ""),
        (model("Real x = 2y;"), "missing-semicolon", 2, 11, "found `y`", "digit"),
        (model("Real x \"a\" \"b\";"), "missing-semicolon", 2, 11, "string", "join strings with +"),
        (model("Real x);"), "missing-semicolon", 2, 7, "found `)`", "no bracket is open"),
        ("within A model M end M;", "missing-semicolon", 1, 9, "`within` clause", ""),
        ("model M end M", "missing-semicolon", 1, 14, "end of the file", ""),
        (model("Real in;"), "keyword", 2, 6, "`in` is a keyword", "'in'"),
        (model("Real Integer;"), "keyword", 2, 6, "predefined type", "another name"),
        (model("Real 2x;"), "unexpected", 2, 6, "component name", "begins with a letter"),
        (model("x = 3;"), "unexpected", 2, 3, "component name", "`equation`"),
        (model("Real x(start == 1);"), "unclosed", 2, 14, "`)`", "="),
        (model("equation\nx := 1;"), "equation", 3, 3, "`:=` assigns", "algorithm"),
        (model("equation\nx == 1;"), "equation", 3, 1, "not with ==", "single ="),
        (model("equation\nder(x);"), "equation", 3, 7, "expected `=`", "not used"),
        (model("equation\nReal x;"), "equation", 3, 6, "found `x`", "declarations come before"),
        (model("equation\nif a then\nelif b then\nend if;"), "equation", 4, 6, "found `b`", "`elseif`"),
        (model("algorithm\nx = 1;"), "statement", 3, 3, "does not assign", ":="),
        (model("algorithm\nconnect(a, b);"), "statement", 3, 1, "`connect`", "equation"),
        (model("algorithm\nx += 1;"), "statement", 3, 3, "found `+`", "x := x + 1"),
        (model("algorithm\n(a, b) := c;"), "unexpected", 3, 12, "function call", "several results"),
        (model("equation\nif a\nx = 1;\nend if;"), "missing-then", 4, 1, "`then` after the condition", ""),
        (model("equation\nif a = b then\nend if;"), "missing-then", 3, 6, "found `=`", "=="),
        (model("equation\nfor i in 1:3\nend for;"), "missing-loop", 4, 1, "`loop`", ""),
        (model("equation\nfor i = 1:3 loop\nend for;"), "missing-loop", 3, 7, "`loop`", "`in`"),
        (model("algorithm\nwhile a do\nend while;"), "missing-loop", 3, 9, "`loop`", "instead of `do`"),
        (model("equation\nx = (a + (b - c);"), "unclosed", 3, 17, "the `(` of line 3, column 5", ""),
        (model("equation\nx = f(a, {1, 2);"), "unclosed", 3, 15, "the `{` of line 3, column 10", "`}`"),
        (model("equation\nx = a[1;"), "unclosed", 3, 8, "the `[` of line 3, column 6", ""),
        (model("equation\nwhen a then\nend if;"), "unclosed-block", 4, 1, "`when` of line 3", "elsewhen"),
        (
            model("equation\nif a then\nelse if b then\nend if;"),
            "unclosed-block", 6, 1, "`if` of line 3", "write `elseif`",
        ),
        (model("equation\nx = 2*-3;"), "sign", 3, 7, "`-` cannot follow `*`", "(-3)"),
        (model("equation\nx = a - -b;"), "sign", 3, 9, "`-` cannot follow `-`", "(-b)"),
        (model("equation\nx = a^-b;"), "sign", 3, 7, "`-` cannot follow `^`", "(-b)"),
        (model("equation\nx = not not a;"), "sign", 3, 9, "`not` cannot follow `not`", "(not a)"),
        (model("equation\nx = a == not b;"), "sign", 3, 10, "`not` cannot follow `==`", "(not b)"),
        (model("equation\nx = a^b^c;"), "chain", 3, 8, "second `^`", "(a^b)^c"),
        (model("equation\nx = a < b < c;"), "chain", 3, 11, "second `<`", "and"),
        (model("equation\nx = 1:2:3:4;"), "chain", 3, 10, "second `:`", "start : step : stop"),
        (model("equation\nx = a ** b;"), "expression", 3, 8, "found `*`", "^"),
        (model("equation\nx = ;"), "expression", 3, 5, "after `=`, found `;`", ""),
        (model("equation\nx = 1 + if a then b else c;"), "expression", 3, 9, "keyword `if`", "parentheses"),
        (model("equation\nx = end;"), "expression", 3, 5, "keyword `end`", ""),
        (model("equation\nx = a[];"), "expression", 3, 7, "found `]`", "a[:]"),
        (model("equation\nx = {};"), "unexpected", 3, 6, "found `}`", "fill(value, 0)"),
        (model("equation\nx = if a then b;"), "unexpected", 3, 16, "`else`", "every case"),
        (model("equation\nx = (a + b)[1];"), "subscript", 3, 12, "only a name", "section 3.2"),
        (model("equation\nx = f(a = 1, 2);"), "argument-order", 3, 14, "follows a named one", "first"),
        (model("A a(b[1] = 2);"), "modification", 2, 6, "no subscripts", "each"),
        (model("A a(redeclare Real[2] b);"), "modification", 2, 19, "no dimensions", "behind the name"),
        (model("A a(break b);"), "unexpected", 2, 5, "keyword `break`", ""),
        (model("inner final Real x;"), "prefix", 2, 7, "`final`", "order"),
        (model("input flow Real x;"), "prefix", 2, 7, "`flow`", "order"),
        (model("annotation(a = 1);\nReal x;"), "unexpected", 3, 1, "after the annotation", "last part"),
        (model("connect(a, b);"), "unexpected", 2, 1, "found the keyword `connect`", "`equation`"),
        (model("equation\nx = 1;;"), "expression", 3, 7, "found `;`", ""),
        ("model M\n\nend N;", "end-name", 3, 5, "does not match `M`, the class begun in line 1", "end M"),
        ("model M\n end if;\nend M;", "end-name", 2, 6, "no `if` is open", "end M"),
        ("model M\nend;", "end-name", 2, 4, "expected `end M`", "end M"),
        ("package P\nmodel M\nReal x;\n", "unclosed-class", 4, 1, "class `M` (begun in line 2)", "end M"),
        ("model M end M; end N;", "unexpected", 1, 16, "found the keyword `end`", "closes no class"),
        ("Model M end M;", "unexpected", 1, 1, "found `Model`", "`model`"),
        ("expandable model M end M;", "prefix", 1, 12, "a model cannot be `expandable`", "connector"),
        ("pure model M end M;", "prefix", 1, 6, "a model cannot be `pure`", "function"),
        ("operator model M end M;", "prefix", 1, 10, "a model cannot be `operator`", "record"),
        ("", "empty", 1, 1, "t.mo is empty", "at least one class"),
        ("// nothing\n", "empty", 1, 1, "defines no class", "at least one class"),
        ("within A;", "empty", 1, 1, "defines no class", "at least one class"),
        ('{"a": 1}', "not-modelica", 1, 1, "JSON", "model M"),
        ("hello world", "not-modelica", 1, 1, "not a Modelica text", "model M"),
        ("<html></html>", "not-modelica", 1, 1, "not a Modelica text", "model M"),
    ],
)  # fmt: skip
def test_message(text: str, code: str, line: int, column: int, message: str, hint: str) -> None:
    diagnostic = refused(text)
    assert diagnostic.span is not None
    assert (diagnostic.code, diagnostic.span.line, diagnostic.span.column) == (f"syntax.{code}", line, column)
    assert message in diagnostic.message
    assert hint in diagnostic.hint


@pytest.mark.parametrize("text", ["", "1 2", "1 +", "a = b", "{1, 2"])
def test_not_one_expression(text: str) -> None:
    with pytest.raises(SyntaxProblem):
        expression(text)


# --------------------------------------------------------------------------- depth and length

NESTS = {
    "parentheses": ("equation x = ", "(", "1", ")", ";"),
    "all operators": ("equation x = ", "(a or b and not c < d + e*f^(", "1", "))", ";"),
    "arrays": ("equation x = ", "{", "1", "}", ";"),
    "matrices": ("equation x = ", "[", "1", "]", ";"),
    "subscripts": ("equation x = ", "a[", "1", "]", ";"),
    "calls": ("equation x = ", "f(", "1", ")", ";"),
    "named": ("equation x = ", "f(a = ", "1", ")", ";"),
    "partial functions": ("equation x = f(", "function f(a = ", "1", ")", ");"),
    "negations": ("equation x = ", "not (", "a", ")", ";"),
    "signs": ("equation x = ", "-(", "1", ")", ";"),
    "if expressions": ("equation x = ", "if a then b else ", "1", "", ";"),
    "conditions": ("equation x = ", "if ", "a", " then b else c", ";"),
    "modifications": ("A a", "(b", " = 1", ")", ";"),
    "redeclarations": ("A a(", "redeclare A b(", "c = 1", ")", ");"),
    "annotations": ("annotation", "(b", " = 1", ")", ";"),
    "if equations": ("equation ", "if a then ", "x = 1;", " end if;", ""),
    "for equations": ("equation ", "for i loop ", "x = 1;", " end for;", ""),
    "when equations": ("equation ", "when a then ", "x = 1;", " end when;", ""),
    "while statements": ("algorithm ", "while a loop ", "x := 1;", " end while;", ""),
    "classes": ("", "model M ", "Real x;", " end M;", ""),
}  # fmt: skip


def nested(name: str, levels: int) -> str:
    before, opening, middle, closing, after = NESTS[name]
    return f"model T {before}{opening * levels}{middle}{closing * levels}{after} end T;"


@pytest.mark.parametrize("name", NESTS)
def test_deep_nesting_is_refused_with_a_typed_error(name: str) -> None:
    diagnostic = refused(nested(name, 5000))
    assert diagnostic.code == "syntax.nesting"
    assert str(NESTING_LIMIT) in diagnostic.message


@pytest.mark.parametrize("name", NESTS)
def test_nesting_up_to_the_limit_parses(name: str) -> None:
    levels = (NESTING_LIMIT - 4) // 2 if name == "all operators" else NESTING_LIMIT - 4
    before = sys.getrecursionlimit()
    definition = parse(Source("t.mo", nested(name, levels)))
    with stack_room():
        assert definition == parse(Source("t.mo", nested(name, levels)))
    assert sys.getrecursionlimit() == before


@pytest.mark.parametrize("operator", ["+", "*", " and ", " or ", " .- "])
def test_long_chains_parse_and_print(operator: str) -> None:
    text = operator.join(["a"] * 10_000)
    spine = expression(text)
    count = 0
    while isinstance(spine, ast.Binary):
        spine, count = spine.left, count + 1
    assert count == 9999
    printed = print_expression(expression(text))
    assert printed.count("a") >= 10_000
    assert print_expression(expression(printed)) == printed


def test_long_lists_parse() -> None:
    arms = "elseif a then b " * 5000
    assert isinstance(expression(f"if a then b {arms}else c"), ast.If)
    only_class("model M\n" + "Real x;\n" * 5000 + "equation\n" + "x = 1;\n" * 5000 + "end M;")
    only_class("model M A a(" + "b." * 5000 + "c = 1); end M;")


# --------------------------------------------------------------------------- fuzzing

VALID = (
    """within A.B;
model M "text" + "more"
  import C.*;
  extends D(break x, final n = 3) annotation(a = 1);
  replaceable Real x[:](each start = 1.5e-3) = {i^2 for i in 1:n} if c constrainedby T(k = 1) "d";
protected
  redeclare model E = F[2](z = 1) annotation(Icon(graphics = {Line(points = [1, 2; 3, 4])}));
  type G = enumeration(a "x", 'b c');
initial equation
  x[end] = if a then b elseif not c then -d else e.f[1, :].g;
equation
  connect(a.b[1], c);
  for i in 1:3, j loop
    when {initial(), x > 0} then
      reinit(x, pre(x)*2 .^ 3);
    elsewhen y <> 1 then
      (a, , b) = f(function g(k = 1), h = "s\\n");
    end when;
  end for "c";
algorithm
  while true loop
    if a then break; else return; end if;
  end while;
  annotation(version = "1");
end M;
""",
    """function f
  input Real u; output Real y;
  external "C" y = g(u) annotation(Include = "x");
end f;
encapsulated partial package P
  operator record R
    operator 'constructor' end 'constructor';
  end R;
  function df = der(f, u);
  expandable connector C flow Real f; stream Real s; end C;
end P;
""",
)  # fmt: skip


def survives(data: bytes) -> None:
    problem = problem_of(data)
    if problem is not None:
        assert str(problem)
        assert all(code.startswith("syntax.") for code in problem.codes)


def problem_of(data: bytes) -> SyntaxProblem | None:
    try:
        parse(decode(data, "fuzz.mo"))
    except SyntaxProblem as problem:
        return problem
    return None


@st.composite
def mutants(draw: st.DrawFn) -> str:
    """A valid text with some tokens deleted, doubled, swapped or replaced."""
    tokens = tokenize(Source("valid", draw(st.sampled_from(VALID)))).texts
    for _ in range(draw(st.integers(1, 4))):
        i, j = draw(st.integers(0, len(tokens) - 1)), draw(st.integers(0, len(tokens) - 1))
        match draw(st.sampled_from(("delete", "double", "swap", "replace"))):
            case "delete":
                tokens = tokens[:i] + tokens[i + 1 :] or [""]
            case "double":
                tokens = [*tokens[:i], tokens[i], *tokens[i:]]
            case "swap":
                tokens[i], tokens[j] = tokens[j], tokens[i]
            case _:
                tokens[i] = tokens[j]
    return " ".join(tokens)


def test_the_texts_to_mutate_are_valid() -> None:
    for text in VALID:
        parse(Source("valid", text))


@given(mutants())
@settings(max_examples=300)
def test_mutated_texts_raise_nothing_else(text: str) -> None:
    survives(text.encode())


@given(st.sampled_from(VALID), st.integers(0, 2000), st.binary(max_size=3))
@settings(max_examples=200)
def test_truncated_and_damaged_bytes_raise_nothing_else(text: str, cut: int, junk: bytes) -> None:
    data = text.encode()
    survives(data[:cut] + junk)
    survives(data[:cut] + junk + data[cut:])


@given(st.lists(st.sampled_from(sorted(set(tokenize(Source("valid", "".join(VALID))).texts))), max_size=30))
@settings(max_examples=200)
def test_random_tokens_raise_nothing_else(tokens: list[str]) -> None:
    survives(("model M " + " ".join(tokens)).encode())


@pytest.mark.parametrize("text", VALID)
def test_every_truncation_raises_nothing_else(text: str) -> None:
    for cut in range(len(text)):
        survives(text[:cut].encode())
