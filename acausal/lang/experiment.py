"""The `experiment` annotation of a class (Modelica 3.6, 18.4)."""

from __future__ import annotations

from acausal.lang import ast
from acausal.lang.arithmetic import type_error
from acausal.lang.flat import Experiment
from acausal.lang.modifiers import Context
from acausal.lang.scope import Scope
from acausal.lang.translation import Translation

_SETTINGS = ("StartTime", "StopTime", "Tolerance", "Interval")


def experiment_of(translation: Translation, scope: Scope) -> Experiment:
    """The settings that the class's annotation gives. Raises `TypeProblem`, `LookupProblem`."""
    annotation = annotation_of(scope)
    for argument in annotation.arguments if annotation is not None else ():
        if isinstance(argument, ast.ElementModification) and argument.name == ("experiment",):
            return _experiment(translation, scope, argument)
    return Experiment()


def annotation_of(scope: Scope) -> ast.Annotation | None:
    """The annotation of a class as written."""
    definition = scope.definition
    if isinstance(definition, ast.LongClass):
        return definition.body.annotation
    return definition.comment.annotation


def _experiment(translation: Translation, scope: Scope, argument: ast.ElementModification) -> Experiment:
    values: dict[str, float] = {}
    modification = argument.modification
    for item in () if modification is None else modification.arguments:
        if not isinstance(item, ast.ElementModification) or item.modification is None:
            continue
        expression = item.modification.value
        name = item.name[0]
        if name not in _SETTINGS or expression is None or isinstance(expression, ast.Break):
            continue
        number = translation.evaluate(expression, Context(scope, None), f"`{name}` of the experiment")
        if not isinstance(number, (int, float)) or isinstance(number, bool):
            message = f"`{name}` of the experiment must be a number"
            raise type_error("type.mismatch", message, expression.span, "", (name,))
        values[name] = float(number)
    return Experiment(*[values.get(name) for name in _SETTINGS])
