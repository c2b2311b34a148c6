"""An explanation as JSON: the contract of docs/explain.md."""

from __future__ import annotations

from collections.abc import Iterable

from acausal.explain.collect import block_equations, unconnected
from acausal.explain.explanation import Explanation
from acausal.explain.words import spot
from acausal.lang.flat import Equation
from acausal.symbolic.causal import Block, CausalEquation, CausalSystem, InitialCondition
from acausal.symbolic.describe import equation_text, leaf_texts
from acausal.symbolic.expressions.text import to_text

Object = dict[str, object]


def explanation_data(explanation: Explanation) -> Object:
    """What `acausal explain --json` prints."""
    system = explanation.system
    return {
        "model": explanation.name,
        "equations": system.equation_count,
        "variables": system.unknown_count,
        "removed": _removed(system),
        "unconnected": list(unconnected(system)),
        "evaluated": list(system.evaluated),
        "aliases": [
            {"name": alias.name, "value": to_text(alias.value), "equation": _equation(alias.equation)}
            for alias in system.aliases
        ],
        "index": system.index,
        "differentiated": [
            {
                "equation": equation_text(entry.equation),
                "times": entry.times,
                "alias": entry.alias or None,
                **spot(entry.equation.span),
            }
            for entry in explanation.differentiated
        ],
        "states": list(system.states),
        "choices": [{"name": c.name, "is_state": c.is_state, "reason": c.reason} for c in system.choices],
        "dynamic": _dynamic(system),
        "blocks": [_block(explanation, number) for number in range(1, len(system.blocks) + 1)],
        "initial": [
            {"name": value.name, "value": to_text(value.value), "reason": value.reason}
            for value in system.initial.values
        ],
        "initial_problem": _initial_problem(explanation),
        "zero_crossings": [
            {"relation": to_text(crossing.relation), **spot(crossing.span)} for crossing in system.events
        ],
        "discrete": [
            {"variable": to_text(a.unknown), "value": to_text(a.value), **spot(a.equation.flat.span)}
            for a in system.discrete.assignments
        ],
        "warnings": [warning.to_json() for warning in explanation.warnings],
        "seconds": dict(explanation.seconds),
    }


def _initial_problem(explanation: Explanation) -> Object:
    """Which conditions the start takes, which are one too many, and which start values nothing uses."""
    initial = explanation.system.initial
    return {
        "needed": initial.needed,
        "initial_equations": initial.equations,
        "assumed": [value.name for value in initial.values if value.reason == "assumed"],
        "surplus": [
            {
                "condition": _condition(conflict.condition),
                "others": [_condition(other) for other in conflict.others],
            }
            for conflict in initial.conflicts
        ],
        "unused": list(initial.unused),
        "homotopy": [_equation(equation) for equation in explanation.homotopies],
    }


def _condition(condition: InitialCondition) -> Object:
    return {"start": condition.start or None, **_equation(condition.equation.flat)}


def _removed(system: CausalSystem) -> Object | None:
    removed = system.removed
    if removed is None:
        return None
    return {
        "for": list(removed.outputs),
        "variables": [variable.name for variable in removed.variables],
        "equations": [_equation(equation) for equation in removed.equations],
        "initial_equations": [_equation(equation) for equation in removed.initial_equations],
        "assertions": [{"text": to_text(a.condition), **spot(a.span)} for a in removed.assertions],
        "whens": [spot(when.span) for when in removed.whens],
    }


def block_data(explanation: Explanation, number: int) -> Object:
    """What `acausal explain --block N --json` prints. Raises `UsageProblem` where there is no such block."""
    block = explanation.block(number)
    return {
        "model": explanation.name,
        **_block(explanation, number),
        "equations": [_causal(equation) for equation in block_equations(block)],
        "assignments": [
            {"unknown": to_text(a.unknown), "value": to_text(a.value)} for a in block.assignments
        ],
        "residuals": [to_text(residual.value) for residual in block.residuals],
        "needed_by": list(explanation.dependencies.needed_by[number]),
    }


def with_latex(data: Object, block: Block) -> Object:
    """`block_data` with the key `latex` for each equation; null where an equation is too long."""
    from acausal.explain.latex import equation_latex

    equations = [
        _causal(equation) | {"latex": equation_latex(equation.left, equation.right)}
        for equation in block_equations(block)
    ]
    return data | {"equations": equations}


def _block(explanation: Explanation, number: int) -> Object:
    block = explanation.system.blocks[number - 1]
    return {
        "number": number,
        "kind": block.kind.value,
        "size": block.size,
        "torn": len(block.tearing),
        "unknowns": list(leaf_texts(block.unknowns)),
        "tearing": list(leaf_texts(block.tearing)),
        "needs": list(explanation.dependencies.needs[number]),
    }


def _equation(equation: Equation) -> Object:
    return {"text": equation_text(equation), **spot(equation.span)}


def _causal(equation: CausalEquation) -> Object:
    return {
        "text": equation_text(equation),
        **spot(equation.flat.span),
        "component": equation.flat.component,
        "differentiated": equation.differentiations,
    }


def _dynamic(system: CausalSystem) -> list[Object]:
    monitors: Iterable[Object] = (
        {
            "while": to_text(monitor.relation),
            "solved_for": list(monitor.solved_for),
            "alternatives": list(monitor.alternatives),
            "constraints": [_equation(constraint.flat) for constraint in monitor.constraints],
        }
        for monitor in (system.dynamic.monitors if system.dynamic is not None else ())
    )
    return list(monitors)
