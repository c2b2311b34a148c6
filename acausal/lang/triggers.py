"""`trigger(c)` of equations that come from algorithms, written with what Modelica has: `when` or `edge`.

`v = if trigger(c1) then e1 else if trigger(c2) then e2 else pre(v)` is a when-clause; in any other equation
`trigger(c)` becomes `edge(b)` with a Boolean `b`, which is a new variable unless `c` is one already.
"""

from __future__ import annotations

from dataclasses import replace

from acausal.lang.flat import BOOLEAN, Equation, FlatModel, Origin, Variability, Variable, When, WhenBranch
from acausal.symbolic.expressions import expr as ex
from acausal.symbolic.expressions.expr import Expr
from acausal.symbolic.expressions.kernel import Named


def without_triggers(flat: FlatModel) -> FlatModel:
    """The same model with `when` and `edge` in place of `trigger`. O(nodes)."""
    work = _Triggers(flat)
    equations: list[Equation] = []
    whens = list(flat.whens)
    for equation in flat.equations:
        if not work.held_by(equation.right):
            equations.append(equation)
            continue
        when = _as_when(equation)
        if when is not None and not any(work.held_by(e.right) for b in when.branches for e in b.equations):
            whens.append(when)
        else:
            equations.append(replace(equation, right=work.with_edges(equation.right)))
    if not work.found:
        return flat
    whens = [work.in_clause(when) for when in whens]
    assertions = [replace(a, condition=work.with_edges(a.condition)) for a in flat.assertions]
    variables, definitions = tuple(work.variables), tuple(work.definitions)
    return replace(
        flat,
        variables=flat.variables + variables,
        equations=(*equations, *definitions),
        assertions=tuple(assertions),
        whens=tuple(whens),
    )


def _as_when(equation: Equation) -> When | None:
    """The when-clause that the equation is, if it is one."""
    branches: list[WhenBranch] = []
    rest = equation.right
    while rest.op == "if":
        conditions = _conditions(rest.args[0])
        if conditions is None:
            return None
        branch = replace(equation, right=rest.args[1], origin=Origin.EQUATION)
        branches.append(WhenBranch(conditions, (branch,), (), (), (), equation.span))
        rest = rest.args[2]
    if equation.left.op != "sym" or rest is not ex.pre(equation.left):
        return None
    return When(tuple(branches), equation.span, equation.component)


def _conditions(test: Expr) -> tuple[Expr, ...] | None:
    """The conditions of `trigger(c1) or trigger(c2) or ...`."""
    parts = test.args if test.op == "or" else (test,)
    if not all(part.op in ("trigger", "initial") for part in parts):
        return None
    return tuple([part.args[0] if part.op == "trigger" else part for part in parts])


class _Triggers:
    """The Booleans that stand for conditions, and the expressions in which they replace them."""

    def __init__(self, flat: FlatModel) -> None:
        self._flat = flat
        self._held: dict[Expr, bool] = {}
        self._edges: dict[Expr, Expr] = {}
        self.found = any(
            [
                *[self.held_by(e.right) for e in flat.equations],
                *[self.held_by(a.condition) for a in flat.assertions],
                *[self.held_by(c) for when in flat.whens for b in when.branches for c in b.conditions],
            ]
        )
        self.variables: list[Variable] = []
        self.definitions: list[Equation] = []

    def held_by(self, root: Expr) -> bool:
        """Whether a trigger is in the expression."""
        return ex.fold([root], lambda node, args: node.op == "trigger" or any(args), self._held)[root]

    def with_edges(self, root: Expr) -> Expr:
        if not self.held_by(root):
            return root
        for node in list(ex.postorder([root])):
            if node.op == "trigger" and node not in self._edges:
                self._edges[node] = ex.call(Named("edge", 1), self._boolean(node.args[0]))
        return ex.substitute(root, self._edges)

    def in_clause(self, when: When) -> When:
        """The clause with edges in its conditions."""
        branches = [
            replace(branch, conditions=tuple([self.with_edges(c) for c in branch.conditions]))
            for branch in when.branches
        ]
        return replace(when, branches=tuple(branches))

    def _boolean(self, condition: Expr) -> Expr:
        if condition.op == "sym":
            return condition
        name = f"$when{len(self.variables) + 1}"
        span = self._flat.span
        self.variables.append(Variable(name, BOOLEAN, Variability.DISCRETE, span, protected=True))
        self.definitions.append(Equation(ex.sym(name), condition, span))
        return ex.sym(name)
