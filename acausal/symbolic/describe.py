"""Words for messages of the symbolic passes: equations, variables and lists of them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from acausal.errors import Span
from acausal.lang.flat import Equation, Origin
from acausal.symbolic.causal import CausalEquation, InitialCondition
from acausal.symbolic.expressions.expr import Expr
from acausal.symbolic.expressions.text import beginning, to_text

SHOWN = 5
"""How many names or equations a message lists before it says `and N more`."""
MOST_TEXT = 100
"""Characters of an equation or expression that a message shows."""


def equation_text(equation: Equation | CausalEquation) -> str:
    """`left = right` as Modelica text."""
    return f"{to_text(equation.left)} = {to_text(equation.right)}"


def shown(equation: Equation | CausalEquation) -> str:
    """`equation_text` for a message: cut where inlined functions make it long; the place says the rest."""
    left, right = (beginning(side, MOST_TEXT) for side in (equation.left, equation.right))
    return cut(f"{left} = {right}")


def cut(text: str) -> str:
    """At most the first `MOST_TEXT` characters."""
    return text if len(text) <= MOST_TEXT else f"{text[:MOST_TEXT].rstrip()} ..."


def short_text(expression: Expr) -> str:
    """The expression for a message, cut."""
    return cut(beginning(expression, MOST_TEXT))


def place(span: Span) -> str:
    """`Tank.mo:12`."""
    return f"{span.file}:{span.line}"


def equation_with_place(equation: Equation) -> str:
    """`0 = a + b (Tank.mo:12, connection in tank)`."""
    where = place(equation.span)
    if equation.origin is not Origin.EQUATION:
        where += f", {equation.origin.value}"
    if equation.component:
        where += f" in {equation.component}"
    return f"`{shown(equation)}` ({where})"


def condition_text(condition: InitialCondition) -> str:
    """`the start value `x` = 2.0 (Tank.mo:12)`, or the initial equation with its place."""
    flat = condition.equation.flat
    if condition.start:
        return f"the start value `{condition.start}` = {short_text(flat.right)} ({place(flat.span)})"
    return f"the initial equation {equation_with_place(flat)}"


def listed(items: Sequence[str], shown: int = SHOWN) -> str:
    """`a, b, c and 4 more`."""
    more = f" and {len(items) - shown} more" if len(items) > shown else ""
    return ", ".join(items[:shown]) + more


def equations_with_places(equations: Sequence[Equation], most: int = SHOWN) -> str:
    """The first equations, as `equation_with_place` has them, and how many more there are."""
    more = f" and {len(equations) - most} more" if len(equations) > most else ""
    return ", ".join([equation_with_place(equation) for equation in equations[:most]]) + more


def quoted(names: Sequence[str], last: str = "and", shown: int = SHOWN) -> str:
    """`` `a`, `b` and `c` ``, or how many more there are."""
    texts = [f"`{name}`" for name in names[:shown]]
    if len(names) > shown:
        return f"{', '.join(texts)} and {len(names) - shown} more"
    return f" {last} ".join([part for part in (", ".join(texts[:-1]), *texts[-1:]) if part])


def counted(number: int, noun: str) -> str:
    """`1 equation`, `3 equations`."""
    return f"{number} {noun}" if number == 1 else f"{number} {noun}s"


def leaf_texts(leaves: Iterable[Expr]) -> tuple[str, ...]:
    """Leaves as text."""
    return tuple(to_text(leaf) for leaf in leaves)


def base_name(leaf: Expr) -> str:
    """The variable of a leaf: `x` of `x`, `der(x)`, `der(der(x))` and `pre(x)`; "" of another `pre`."""
    while leaf.op != "sym":
        if not leaf.args:
            return ""
        leaf = leaf.args[0]
    return leaf.name


def dots(name: str) -> int:
    """How deep in the component tree a variable is declared."""
    return name.count(".")
