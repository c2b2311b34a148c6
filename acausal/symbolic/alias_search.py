"""The search behind alias elimination: rounds of finding aliases and substituting where they occur."""

from __future__ import annotations

from collections.abc import Iterable

from acausal.errors import BalanceProblem
from acausal.lang.flat import Equation, FlatModel, Variability, Variable
from acausal.symbolic.alias_classes import Classes, Group, Link, Pinned
from acausal.symbolic.alias_errors import (
    balanced,
    no_unknown_left,
    not_differentiable,
    redundant_link,
    two_values,
)
from acausal.symbolic.attributes import representative_key, same_value, signed, start_or_default
from acausal.symbolic.describe import base_name
from acausal.symbolic.expressions.diff import NotDifferentiable
from acausal.symbolic.expressions.expr import (
    TIME,
    ZERO,
    Expr,
    const,
    der,
    div,
    neg,
    postorder,
    sub,
    sym,
)
from acausal.symbolic.expressions.linear import linear_coefficient
from acausal.symbolic.expressions.operators import KNOWN_AT_EVENTS
from acausal.symbolic.expressions.simplify import split_factor
from acausal.symbolic.leaves import Chains, Rewriter, all_leaves, is_input
from acausal.symbolic.occurrences import Occurrences
from acausal.symbolic.parameters import ParameterValues


def plain_pair(left: Expr, right: Expr) -> tuple[str, str, int] | None:
    """The names and sign of `a = b`, `a = -b`, `0 = a + b` or `0 = a - b`, as written; else None."""
    if left.op == "sym" and right.op == "sym":
        return left.name, right.name, 1
    if left.op == "sym" and right.op == "neg" and right.args[0].op == "sym":
        return left.name, right.args[0].name, -1
    if left.op == "const" and right.op == "add" and left.value == 0:
        terms = right.args
    elif right.op == "const" and left.op == "add" and right.value == 0:
        terms = left.args
    else:
        return None
    if len(terms) != 2:
        return None
    one, other = terms
    same = one.op == other.op
    a, b = (term.args[0] if term.op == "neg" else term for term in terms)
    if a.op != "sym" or b.op != "sym":
        return None
    return a.name, b.name, -1 if same else 1


class AliasSearch:
    """The working memory of alias elimination: current equations, classes, named derivatives."""

    def __init__(self, flat: FlatModel, values: ParameterValues) -> None:
        self.flat = flat
        self.values = values
        self.classes = Classes()
        self.left = [equation.left for equation in flat.equations]
        self.right = [equation.right for equation in flat.equations]
        self.live = [True] * len(flat.equations)
        self.level = [0] * len(flat.equations)
        self.named: dict[str, str] = {}
        self.named_by: dict[str, int] = {}
        self.current: dict[str, Expr] = {}
        """Per eliminated variable what stands for it now."""
        self.differentiated: dict[str, None] = {}
        self.has_homotopy = False
        """Whether an equation holds the operator `homotopy`, of which only the actual value is left here."""
        self._chain_classes = Classes()
        self._taken: dict[str, str] = {}
        """v -> x for every named derivative."""
        self._position = {v.name: i for i, v in enumerate(flat.variables)}
        self._unknown = {v.name: v for v in flat.variables if v.is_unknown and not is_input(v)}
        self._ranks: dict[str, tuple[object, ...]] = {}
        self._occurrences = Occurrences(len(flat.equations), self._unknown, self.differentiated)
        self._leaves = self._occurrences.leaves
        self._candidates: dict[int, None] = {}
        """Equations that look like v = der(x)."""

    def position(self, name: str) -> int:
        """Place in declaration order."""
        return self._position[name]

    def determined(self, flat: FlatModel) -> tuple[Variable, ...]:
        """Variables the equations determine, as `flat` (with other attributes) declares them."""
        return tuple(v for v in flat.variables if v.name in self._unknown)

    def derivative_leaf(self, x: str) -> Expr:
        """`der(x)` as a leaf, whatever its name."""
        return der(sym(x))

    def roots(self) -> list[str]:
        """One member of every class of more than one variable or with a value: its representative. Linear."""
        seen: dict[int, str] = {}
        for name in sorted(self.current, key=self.position):
            group = self.classes.of(name)
            if id(group) not in seen:
                seen[id(group)] = self._representative(group)
        return list(seen.values())

    def run(self) -> None:
        """Eliminate until nothing changes."""
        evaluated = {sym(name): const(value) for name, value in self.values.evaluated.items()}
        touched = self._find_plain()
        changed = self._rewrite(range(len(self.live)), evaluated)
        while changed or touched:
            self._find(changed, touched)
            changed = self._substitute(touched)
            touched = {}
            if not changed:
                changed = self._name_derivatives()

    def _find_plain(self) -> dict[str, None]:
        """Put the pairs that need no rewriting into classes; most equations of connections are such."""
        touched: dict[str, None] = {}
        for i, (left, right) in enumerate(zip(self.left, self.right, strict=True)):
            pair = plain_pair(left, right)
            if pair is None:
                continue
            a, b, sign = pair
            if self._may_link(a, b, sign):
                self._link(Link(a, b, sign, i), touched)
        return touched

    def _find(self, equations: Iterable[int], touched: dict[str, None]) -> None:
        """Put the aliases among `equations` into classes; adds the names whose class changed."""
        for i in equations:
            leaves = self._leaves[i]
            if not self.live[i] or len(leaves) > 2:
                continue
            if not leaves:
                raise no_unknown_left(self.flat, self.values, i, self.left[i], self.right[i])
            if len(leaves) == 1 and leaves[0].op == "sym":
                self._find_constant(i, leaves[0], touched)
            elif len(leaves) == 2:
                self._find_pair(i, leaves, touched)

    def _find_constant(self, i: int, leaf: Expr, touched: dict[str, None]) -> None:
        value = self._solved(i, leaf)
        if value is None or not self._is_parametric(value):
            return
        known = self.classes.value(leaf.name)
        if known is not None:
            raise self._two_values(i, leaf.name, value, known)
        self.classes.pin(Pinned(leaf.name, value, i), self.level[i])
        self.live[i] = False
        touched[leaf.name] = None

    def _solved(self, i: int, leaf: Expr) -> Expr | None:
        """The value of `leaf` if the equation gives it without dividing by anything but a literal."""
        left, right = self.left[i], self.right[i]
        for one, other in ((left, right), (right, left)):
            if one is leaf and leaf not in all_leaves([other]):
                return other
        if self._unknown[leaf.name].type.name != "Real":
            return None
        parts = linear_coefficient(sub(left, right), leaf)
        if parts is None or parts[0].op != "const":
            return None
        if parts[0].number == 0:
            raise no_unknown_left(self.flat, self.values, i, *balanced(parts[1]))
        return neg(div(parts[1], parts[0]))

    def _is_parametric(self, value: Expr) -> bool:
        variables = self.flat.by_name
        return all(
            leaf.op == "sym"
            and leaf is not TIME
            and leaf.name in variables
            and not variables[leaf.name].is_unknown
            for leaf in all_leaves([value])
        ) and not any(node.op in KNOWN_AT_EVENTS for node in postorder([value]))

    def _find_pair(self, i: int, leaves: tuple[Expr, ...], touched: dict[str, None]) -> None:
        sign = self._sign_of_pair(self.left[i], self.right[i])
        if sign is None:
            return
        a, b = leaves
        if a.op != "sym" or b.op != "sym":
            if sign > 0:
                self._candidates[i] = None
            return
        if self._may_link(a.name, b.name, sign):
            self._link(Link(a.name, b.name, sign, i), touched)

    def _may_link(self, a: str, b: str, sign: int) -> bool:
        """Whether both are unknowns of one type and variability that can be equal, or opposite."""
        first, second = self._unknown.get(a), self._unknown.get(b)
        if first is None or second is None or first is second:
            return False
        if first.variability != second.variability:
            return False
        if first.type != second.type or (sign < 0 and first.type.name not in ("Real", "Integer")):
            return False
        return first.variability is Variability.CONTINUOUS or self._start_alike(a, b, sign)

    def _start_alike(self, a: str, b: str, sign: int) -> bool:
        """Whether discrete variables agree before the start: `fixed` is about `pre(v)` there (8.6)."""
        first, second = self._fixed_value(a), self._fixed_value(b)
        if first is None or second is None:
            return True
        return same_value(first, signed(second, sign), self.values) is not False

    def _fixed_value(self, name: str) -> Expr | None:
        """What the start of a member of its class says of a discrete variable's value before the start."""
        group = self.classes.find(name)
        fixed = name if self._unknown[name].fixed else "" if group is None else group.fixed
        if not fixed:
            return None
        sign = 1 if group is None else group.signs[name] * group.signs[fixed]
        return signed(start_or_default(self._unknown[fixed], self.values), sign)

    def _sign_of_pair(self, left: Expr, right: Expr) -> int | None:
        """+1 for a = b, -1 for a = -b (also as sums, also with equal literal factors), else None."""
        if left.op in ("sym", "der") and right.op in ("sym", "der"):
            return 1
        difference = sub(left, right)
        if difference.op != "add" or len(difference.args) != 2:
            return None
        (fa, a), (fb, b) = (split_factor(term) for term in difference.args)
        if a is None or b is None or a.op not in ("sym", "der") or b.op not in ("sym", "der"):
            return None
        return None if abs(fa) != abs(fb) else (1 if fa == -fb else -1)

    def _link(self, link: Link, touched: dict[str, None]) -> None:
        one, other = self.classes.find(link.a), self.classes.find(link.b)
        if one is other and one is not None:
            if one.signs[link.a] == link.sign * one.signs[link.b] or one.pinned is not None:
                raise redundant_link(self.flat, self.classes, link)
            self.classes.pin(Pinned(link.a, ZERO, link.equation), self.level[link.equation])
        else:
            first = None if one is None else one.value(link.a)
            second = None if other is None else other.value(link.b)
            if first is not None and second is not None:
                raise self._two_values(link.equation, link.a, signed(second, link.sign), first, link.b)
            self.classes.link(link, self.level[link.equation])
            group = self.classes.of(link.a)
            group.fixed = group.fixed or next((n for n in (link.a, link.b) if self._unknown[n].fixed), "")
        self.live[link.equation] = False
        touched[link.a] = None

    def _two_values(self, i: int, name: str, value: Expr, known: Expr, beyond: str = "") -> BalanceProblem:
        """Equation `i` gives `name` a value (that of `beyond`, if it is a link), but it has one already."""
        other, between = self._source(name, i)
        if beyond:
            last, before = self._source(beyond, i)
            between = [*before, last, *between]
        equations = self.flat.equations
        steps = [equations[step] for step in dict.fromkeys(between) if step not in (i, other)]
        return two_values(self.values, name, (equations[i], value), (equations[other], known), steps)

    def _source(self, name: str, default: int) -> tuple[int, list[int]]:
        """The equation that gives the class of `name` its value, and the links from there."""
        pinned = self.classes.of(name).pinned
        if pinned is None:
            return default, []
        return pinned.equation, [step.equation for step in self.classes.path(name, pinned.name)]

    def _representative(self, group: Group) -> str:
        return min(group.signs, key=self._rank)

    def _rank(self, name: str) -> tuple[object, ...]:
        """`representative_key`, computed once while it stays the same."""
        moving = name in self.differentiated
        known = self._ranks.get(name)
        if known is None or known[1] is moving:
            known = self._ranks[name] = representative_key(self._unknown[name], moving, self._position[name])
        return known

    def _substitute(self, touched: Iterable[str]) -> list[int]:
        """Replace the members of the touched classes; the equations that changed."""
        values: dict[Expr, Expr] = {}
        levels: dict[str, int] = {}
        groups = {id(group): group for group in map(self.classes.of, touched)}
        for group in groups.values():
            if group.pinned is None:
                chosen = self._representative(group)
                plus, own_sign = sym(chosen), group.signs[chosen]
            else:
                chosen = ""
                plus, own_sign = group.pinned.value, group.signs[group.pinned.name]
            minus = neg(plus)
            moving = sum([name in self.differentiated for name in group.signs])
            level = group.level + 1 if moving > 1 or (moving and group.pinned) else 0
            for name, sign in group.signs.items():
                value = plus if sign == own_sign else minus
                if name == chosen:
                    self.current.pop(name, None)
                elif self.current.get(name) is not value:
                    values[sym(name)] = self.current[name] = value
                    levels[name] = level
        return self._apply(values, levels)

    def _apply(self, values: dict[Expr, Expr], levels: dict[str, int]) -> list[int]:
        self._restore_named(levels)
        equations: dict[int, None] = {}
        for name, level in levels.items():
            for i in self._occurrences.of(name):
                equations[i] = None
                leaves = self._occurrences.all_leaves(i, (self.left[i], self.right[i])) if level else ()
                if any(leaf.op == "der" and base_name(leaf) == name for leaf in leaves):
                    self.level[i] = max(self.level[i], level)
        return self._rewrite(dict.fromkeys(sorted(equations)), values)

    def _restore_named(self, eliminated: dict[str, int]) -> None:
        """Take back the names of derivatives that touch an eliminated variable: their equations return."""
        for name in eliminated:
            for x in (name, self._taken.get(name)):
                if x is None or x not in self.named:
                    continue
                v, i = self.named.pop(x), self.named_by.pop(x)
                del self._taken[v]
                self.left[i], self.right[i] = sym(v), der(sym(x))
                self._leaves[i] = (sym(v), der(sym(x)))
                self.live[i] = True
                for occurring in (x, v):
                    self._occurrences.add(occurring, i)

    def _rewrite(self, equations: Iterable[int], values: dict[Expr, Expr]) -> list[int]:
        """Rewrite equations with `values` and the named derivatives; those still live."""
        rewrite = Rewriter(values, Chains(self.flat.by_name, self.named), self.values.lookup)
        changed: list[int] = []
        for i in equations:
            if not self.live[i]:
                continue
            flat = self.flat.equations[i]
            self.left[i], self.right[i] = self.rewritten(rewrite, self.left[i], self.right[i], flat)
            self._occurrences.update(i, (self.left[i], self.right[i]))
            changed.append(i)
        self.has_homotopy |= rewrite.met_homotopy
        return changed

    def rewritten(self, rewrite: Rewriter, left: Expr, right: Expr, flat: Equation) -> tuple[Expr, Expr]:
        """Both sides of an equation rewritten, with a typed error where `der(...)` does not exist."""
        try:
            return rewrite(left), rewrite(right)
        except NotDifferentiable as problem:
            raise not_differentiable(problem, flat) from None

    def _name_derivatives(self) -> list[int]:
        """Let v be the derivative of x where an equation v = der(x) says so; the equations that changed."""
        equations: dict[int, None] = {}
        for i in sorted(self._candidates):
            pair = self._named_pair(i) if self.live[i] else None
            if pair is None:
                continue
            x, v = pair
            self.named[x], self.named_by[x], self._taken[v] = v, i, x
            self._chain_classes.link(Link(x, v, 1, i), 0)
            self.live[i] = False
            equations.update(dict.fromkeys(self._occurrences.of(x)))
        self._candidates = {}
        return self._rewrite(sorted(equations), {})

    def _named_pair(self, i: int) -> tuple[str, str] | None:
        leaves = self._leaves[i]
        if len(leaves) != 2 or self._sign_of_pair(self.left[i], self.right[i]) != 1:
            return None
        v, slope = leaves if leaves[0].op == "sym" else leaves[::-1]
        if v.op != "sym" or slope.op != "der" or slope.args[0].op != "sym":
            return None
        x = slope.args[0].name
        if (
            x in self.named
            or v.name in self._taken
            or self._unknown[v.name].variability < Variability.CONTINUOUS
        ):
            return None
        chain = self._chain_classes.find(x)
        if x == v.name or (chain is not None and chain is self._chain_classes.find(v.name)):
            return None
        return x, v.name
