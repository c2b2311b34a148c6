"""Kinds of the expressions of a flat model: symbols by declaration, the rest by `expression_types`."""

from __future__ import annotations

from dataclasses import dataclass, field
from difflib import get_close_matches

from acausal.errors import Diagnostic, Span
from acausal.lang.expression_types import (
    EQUALITIES,
    REAL_CONTINUOUS,
    Kind,
    TypeMistake,
    kind,
    kind_of,
    short_text,
)
from acausal.lang.flat import REAL, Variability, Variable
from acausal.symbolic.expressions.expr import TIME, Expr, fold, symbols


@dataclass
class Typing:
    """Kinds of the nodes met so far, for one run."""

    variables: dict[str, Variable]
    at_event: bool = False
    """Where every variable is discrete: in when-clauses, algorithms and initial equations, asked last."""
    memo: dict[Expr, Kind] = field(default_factory=lambda: {TIME: REAL_CONTINUOUS})
    shared: dict[int, list[Kind]] = field(default_factory=dict[int, "list[Kind]"])
    """Kinds of the arguments of calls."""
    calls: dict[tuple[int, str], Kind] = field(default_factory=dict[tuple[int, str], Kind])
    equalities: dict[Expr, None] = field(default_factory=dict[Expr, None])
    """Comparisons of Reals by `==` or `<>` that may raise events."""
    searched: set[Expr] = field(default_factory=set[Expr])

    def kind(self, root: Expr) -> Kind:
        """The kind of an expression that stands in the model; raises `TypeMistake`."""
        found = self.memo.get(root)
        if found is None:
            found = fold([root], self.visit, self.memo, self.shared)[root]
        if self.equalities:
            self.refuse_equalities(root)
        return found

    def visit(self, node: Expr, args: list[Kind]) -> Kind:
        """The kind of a node from those of its arguments."""
        if node.op == "sym":
            return self.symbol(node)
        result = self.call(node, args) if node.op == "call" else kind_of(node, args)
        if node.op in EQUALITIES and REAL in (args[0].type, args[1].type):
            if result.raw > Variability.PARAMETER and not _is_change(node):
                self.equalities[node] = None
        elif node.op == "pre" and args[0].variability > Variability.DISCRETE and not self.at_event:
            message = f"pre needs a discrete variable, but {short_text(node.args[0])} is continuous"
            raise TypeMistake("type.pre", message, node)
        return result

    def call(self, node: Expr, args: list[Kind]) -> Kind:
        """The kind of a call; those of one function with the same arguments have one kind."""
        key = (id(node.args), node.kernel.result)
        if len(args) != node.kernel.arity or id(node.args) not in self.shared:
            return kind_of(node, args)
        if key not in self.calls:
            self.calls[key] = kind_of(node, args)
        return self.calls[key]

    def symbol(self, node: Expr) -> Kind:
        """The kind of a variable or parameter."""
        variable = self.variables.get(node.name)
        if variable is None:
            near = get_close_matches(node.name, self.variables, 1)
            hint = f"did you mean `{near[0]}`?" if near else ""
            raise TypeMistake("flat.unknown-name", f"`{node.name}` is not declared", node, hint)
        return kind(variable.type, variable.variability)

    def refuse_equalities(self, root: Expr) -> None:
        """Look for them outside `noEvent`; what was searched without finding any is not searched again."""
        stack = [root]
        while stack:
            node = stack.pop()
            if node in self.equalities:
                message = (
                    f"{short_text(node)} compares Reals for equality, which is allowed in functions only"
                )
                hint = "use `<` or `>`, or a tolerance: `abs(a - b) < eps`"
                raise TypeMistake("type.real-equality", message, node, hint)
            if node not in self.searched and node.op != "noEvent":
                self.searched.add(node)
                stack.extend(node.args)


def _is_change(node: Expr) -> bool:
    """`x <> pre(x)`, which is `change(x)`, or `x == pre(x)`."""
    a, b = node.args
    return (b.op == "pre" and b.args[0] is a) or (a.op == "pre" and a.args[0] is b)


def mistake_in(mistake: TypeMistake, span: Span, *names: str) -> Diagnostic:
    """The diagnostic of an expression without a type, with the names in it after `names`."""
    all_names = tuple(dict.fromkeys([*names, *symbols([mistake.node])]))
    return Diagnostic(mistake.code, mistake.message, span, all_names, mistake.hint)
