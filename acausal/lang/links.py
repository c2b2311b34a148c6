"""Where a model connects: its `connect` equations and the operators of overconstrained connections.

These may stand in loops and in branches that parameters decide (Modelica 3.6, 9.3); what they say together is
needed before the other equations are translated.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

from acausal.lang import ast
from acausal.lang.arithmetic import as_boolean
from acausal.lang.instance import Array, Instance, Leaf, Member, Outer
from acausal.lang.iteration import iterate
from acausal.lang.light import light_object
from acausal.lang.modifiers import Context
from acausal.lang.translation import Env, Translation

GRAPH_CALLS = ("Connections.branch", "Connections.root", "Connections.potentialRoot")


@light_object
class Link:
    """A `connect` equation, or a call of one of `GRAPH_CALLS`, for one set of values of its iterators."""

    node: ast.ConnectEquation | ast.Call
    env: Env


@dataclass(slots=True)
class _Search:
    """Which equations hold links, found once each."""

    holds: dict[int, bool] = field(default_factory=dict[int, bool])

    def has_links(self, equations: Sequence[ast.Equation]) -> bool:
        return any(self.is_link(equation) for equation in equations)

    def is_link(self, node: ast.Equation) -> bool:
        found = self.holds.get(id(node))
        if found is None:
            found = self.holds[id(node)] = self._look(node)
        return found

    def _look(self, node: ast.Equation) -> bool:
        if isinstance(node, ast.ConnectEquation):
            return True
        if isinstance(node, ast.CallEquation):
            return call_name(node.call) in GRAPH_CALLS
        if isinstance(node, ast.ForEquation):
            return self.has_links(node.body)
        if isinstance(node, ast.IfEquation):
            return any(self.has_links(body) for _, body in node.branches) or self.has_links(node.otherwise)
        return False


def call_name(node: ast.Call) -> str:
    """The name of a function without a leading dot."""
    return node.function.text.removeprefix(".")


def components(root: Instance) -> list[Instance]:
    """All components, depth first, each before its parts."""
    found: list[Instance] = []
    stack: list[Member | Outer] = [root]
    while stack:
        member = stack.pop()
        if isinstance(member, Instance):
            found.append(member)
            stack.extend([m for m in reversed(member.members.values()) if not isinstance(m, Leaf)])
        elif isinstance(member, Array) and member.type is None:
            stack.extend(reversed(member.items))
        elif isinstance(member, Outer) and member.own is not None:
            stack.append(member.own)
    return found


def links_of(translation: Translation, root: Instance) -> list[Link]:
    """All links of a model, component by component."""
    search = _Search()
    found: list[Link] = []
    for instance in components(root):
        for section, scope in instance.scope.table.sections:
            if isinstance(section, ast.EquationSection) and not section.initial:
                env = Env(Context(scope, instance))
                found += _links(translation, search, section.equations, env)
    return found


def _links(
    translation: Translation, search: _Search, equations: Sequence[ast.Equation], env: Env
) -> Iterator[Link]:
    for node in equations:
        if not search.is_link(node):
            continue
        if isinstance(node, ast.ConnectEquation):
            yield Link(node, env)
        elif isinstance(node, ast.CallEquation):
            yield Link(node.call, env)
        elif isinstance(node, ast.ForEquation):
            for inner in iterate(translation, node.iterators, env, node.body):
                yield from _links(translation, search, node.body, inner)
        elif isinstance(node, ast.IfEquation):
            yield from _links(translation, search, _taken(translation, node, env), env)


def _taken(translation: Translation, node: ast.IfEquation, env: Env) -> Sequence[ast.Equation]:
    """The branch that parameters decide for; none if variables do, which is refused elsewhere."""
    for condition, body in node.branches:
        known = translation.decide(as_boolean(translation.value(condition, env), condition.span))
        if known is None:
            return ()
        if known:
            return body
    return node.otherwise
