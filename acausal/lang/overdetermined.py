"""Overdetermined records and types: those with a function `equalityConstraint` (Modelica 3.6, 9.4.1)."""

from __future__ import annotations

from dataclasses import dataclass, field

from acausal.errors import AcausalError, Span, UnsupportedProblem, fail
from acausal.lang.component_plan import Plan
from acausal.lang.scope import Scope


@dataclass(slots=True)
class Overdetermined:
    """The overdetermined components of a model: their functions `equalityConstraint` by path."""

    functions: dict[str, Scope] = field(default_factory=dict[str, Scope])
    _of_class: dict[Scope, Scope | None] = field(default_factory=dict[Scope, "Scope | None"])

    def note(self, scope: Scope, path: str) -> None:
        """Remember a component of a record."""
        function = self._function(scope)
        if function is not None:
            self.functions[path] = function

    def note_variable(self, plan: Plan) -> None:
        """Remember a variable; it is one node together with the dimensions of its type."""
        function = self._function(plan.type)
        if function is not None:
            if plan.declaration.dimensions is not None or plan.clause.dimensions is not None:
                raise _array(plan.path, plan.declaration.span)
            self.functions[plan.path] = function

    def _function(self, scope: Scope) -> Scope | None:
        if scope not in self._of_class:
            entry = None if scope.is_predefined else scope.find_class_entry("equalityConstraint")
            self._of_class[scope] = None if entry is None else scope.nested(entry)
        return self._of_class[scope]


def _array(path: str, span: Span) -> AcausalError:
    """The refusal of an array of an overdetermined type, each element of which would be a node (9.4)."""
    message = f"`{path}` is an array of an overdetermined type, which is not supported"
    hint = "put the overdetermined type into a record, and make an array of records"
    return fail(
        UnsupportedProblem, "unsupported.overdetermined-array", message, span, names=[path], hint=hint
    )
