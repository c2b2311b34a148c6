"""Texts of a model's own, such as messages of assertions, with the values that variables have in a run."""

from __future__ import annotations

from collections.abc import Sequence

from acausal.lang.flat import BOOLEAN, INTEGER, STRING, Variable
from acausal.simulate.evaluator import Evaluator
from acausal.simulate.messages import number, some
from acausal.symbolic.expressions.evaluate import EvaluationFailed, NotConstant, evaluate
from acausal.symbolic.expressions.expr import TIME, Constant, Expr
from acausal.symbolic.expressions.text import to_text


def message_text(message: Expr, evaluator: Evaluator) -> str:
    """The text at the point that was evaluated last; as it is written where a value is missing."""
    if message.is_const:
        return str(message.value)
    evaluator.output()
    known = _known(evaluator)
    variables = evaluator.code.system.flat.by_name

    def lookup(name: str) -> Constant | None:
        variable = variables.get(name)
        if variable is not None and variable.type == STRING:
            return None if variable.binding is None else evaluate(variable.binding, lookup)
        value = known.get(name)
        return value if value is None or variable is None else _of_type(value, variable)

    try:
        return str(evaluate(message, lookup))
    except (NotConstant, EvaluationFailed):
        return to_text(message)


def point_text(evaluator: Evaluator, names: Sequence[str]) -> str:
    """`x = 1, y = 2` for those of the names that have a value at the evaluator's point."""
    evaluator.output()
    known = _known(evaluator)
    return some([f"{name} = {number(known[name])}" for name in names if name in known])


def _known(evaluator: Evaluator) -> dict[str, float]:
    """Variables, parameters and time by name, as the outputs were evaluated last."""
    code = evaluator.code
    values = dict(zip(code.output_leaves, evaluator.output.outputs[0].tolist(), strict=True))
    known = {leaf.name: value for leaf, value in values.items() if leaf.op == "sym"}
    known |= dict(zip(code.system.parameters, evaluator.p.tolist(), strict=True))
    known[TIME.name] = float(evaluator.t[0])
    return known


def _of_type(value: float, variable: Variable) -> Constant:
    """The number that the code computes with as a value of the variable's type."""
    if variable.type == BOOLEAN:
        return value != 0
    return round(value) if variable.type == INTEGER or variable.type.is_enumeration else value
