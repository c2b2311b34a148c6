r"""Expressions as LaTeX through SymPy: `der(valve.spool.s)` becomes `\dot{s}_{\mathrm{valve.spool}}`.

SymPy prints sums, products, quotients and powers, unevaluated and in their order; everything else (functions,
conditions, derivatives) is an atom to it whose LaTeX is made here. An expression of more than `MOST_NODES`
nodes, written out, or of more than `MOST_DEPTH` levels has no LaTeX.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

import sympy

from acausal.symbolic.expressions.expr import EnumValue, Expr, fold
from acausal.symbolic.expressions.operators import RELATIONS
from acausal.symbolic.expressions.text import constant_text

MOST_NODES, MOST_DEPTH = 400, 40
_LARGEST_INTEGER = 1e9
_GREEK = frozenset(
    "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi pi rho sigma tau upsilon phi "
    "chi psi omega Gamma Delta Theta Lambda Xi Pi Sigma Upsilon Phi Psi Omega".split()
)
_ESCAPES = str.maketrans(
    {c: "\\" + c for c in "_{}$#%&"} | {"\\": r"\backslash{}", "^": r"\wedge{}", "~": r"\sim{}", "\n": " "}
)
_NAME = re.compile(r"(?:([^']*)\.)?([^\W\d_]+)(?:_([^'\].]+?))?(?:\[([^'\]]*)\])?")
"""Path, variable, what follows its first underscore, and its subscripts; other names stay whole."""
_DOTS = ("", r"\dot", r"\ddot", r"\dddot")
_FUNCTIONS = {name: rf"\{name}" for name in "sin cos tan sinh cosh tanh exp min max".split()} | {
    "asin": r"\arcsin",
    "acos": r"\arccos",
    "atan": r"\arctan",
    "log": r"\ln",
    "log10": r"\log_{10}",
}
_SIGNS = {"lt": "<", "le": r"\le", "gt": ">", "ge": r"\ge", "eq": "=", "ne": r"\ne"}
_WRAPPED = frozenset({"noEvent", "smooth", "derived"})
_ARITHMETIC = frozenset({"add", "neg", "mul", "div", "pow", "sqrt"})


def expression_latex(root: Expr) -> str | None:
    """The LaTeX of an expression; None where it is longer than anyone would read."""
    if not _is_readable(root):
        return None
    with sympy.evaluate(False):
        return _Printer().latex(root)


def equation_latex(left: Expr, right: Expr) -> str | None:
    """The LaTeX of `left = right`; None where a side is too long."""
    sides = expression_latex(left), expression_latex(right)
    return None if sides[0] is None or sides[1] is None else f"{sides[0]} = {sides[1]}"


def name_latex(name: str, dots: int = 0) -> str:
    r"""A flat name, `dots` times differentiated: `a.tau_start` is `\tau_{\mathrm{a},\mathrm{start}}`."""
    found = _NAME.fullmatch(name)
    path, base, *indices = found.groups(default="") if found else ("", name)
    letter = f"\\{base}" if base in _GREEK else base if len(base) == 1 and base.isalpha() else _roman(base)
    if dots:
        letter = f"{_DOTS[dots]}{{{letter}}}" if dots < len(_DOTS) else f"{letter}^{{({dots})}}"
    below = ",".join([_roman(part) for part in (path, *indices) if part])
    return f"{letter}_{{{below}}}" if below else letter


def _roman(text: str) -> str:
    return text if text.isdigit() else rf"\mathrm{{{text.translate(_ESCAPES)}}}"


def _is_readable(root: Expr) -> bool:
    """Whether the expression as a tree is small; it is stored with shared parts."""

    def visit(_: Expr, parts: list[tuple[int, int]]) -> tuple[int, int]:
        nodes = 1 + sum([nodes for nodes, _ in parts])
        return min(nodes, MOST_NODES + 1), 1 + max([depth for _, depth in parts], default=0)

    nodes, depth = fold([root], visit)[root]
    return nodes <= MOST_NODES and depth <= MOST_DEPTH


class _Printer:
    """One expression; `names` holds the LaTeX of SymPy's atoms."""

    def __init__(self) -> None:
        self.names: dict[sympy.Expr, str] = {}

    def latex(self, root: Expr) -> str:
        return self.text(fold([root], self.visit)[root])

    def text(self, expression: sympy.Expr) -> str:
        return sympy.latex(expression, symbol_names=self.names, order="none", mul_symbol="dot")

    def visit(self, node: Expr, args: list[sympy.Expr]) -> sympy.Expr:
        if node.op == "const" and isinstance(node.value, int | float) and not isinstance(node.value, bool):
            return _number(node.number)
        if node.op in _ARITHMETIC:
            return _arithmetic(node.op, args)
        if node.op in _WRAPPED:
            return args[0]
        atom = self.atom(node, [self.text(arg) for arg in args])
        symbol = sympy.Symbol(atom)
        self.names[symbol] = atom
        return symbol

    def atom(self, node: Expr, args: Sequence[str]) -> str:
        op = node.op
        if op == "sym":
            return "t" if node.name == "time" else name_latex(node.name)
        if op == "const":
            return _roman(node.value.literal if isinstance(node.value, EnumValue) else _constant(node))
        if op == "der":
            return _derivative(node)
        if op in RELATIONS:
            return rf"\left({args[0]} {_SIGNS[op]} {args[1]}\right)"
        if op in ("and", "or"):
            joined = (r" \wedge " if op == "and" else r" \vee ").join(args)
            return rf"\left({joined}\right)"
        if op == "not":
            return rf"\neg {args[0]}"
        if op == "if":
            return (
                rf"\begin{{cases}} {args[1]} & \text{{if }} {args[0]} \\ "
                rf"{args[2]} & \text{{else}} \end{{cases}}"
            )
        if op == "abs":
            return rf"\left|{args[0]}\right|"
        head = _roman(node.kernel.name) if op == "call" else _FUNCTIONS.get(op, rf"\operatorname{{{op}}}")
        return rf"{head}\left({', '.join(args)}\right)"


def _constant(node: Expr) -> str:
    return "" if node.value is None else constant_text(node.value)


def _number(value: float) -> sympy.Expr:
    whole = abs(value) < _LARGEST_INTEGER and value == int(value)
    return sympy.Integer(int(value)) if whole else sympy.Float(value)


def _arithmetic(op: str, args: Sequence[sympy.Expr]) -> sympy.Expr:
    if op == "add":
        return sympy.Add(*args)
    if op == "neg":
        return sympy.Mul(sympy.Integer(-1), args[0])
    if op == "mul":
        return sympy.Mul(*args)
    if op == "div":
        return sympy.Mul(args[0], sympy.Pow(args[1], sympy.Integer(-1)))
    return sympy.Pow(*args) if op == "pow" else sympy.sqrt(args[0])


def _derivative(node: Expr) -> str:
    dots, inner = 0, node
    while inner.op == "der":
        dots, inner = dots + 1, inner.args[0]
    if inner.op == "sym":
        return name_latex(inner.name, dots)
    return r"\operatorname{der}\left(\dots\right)"
