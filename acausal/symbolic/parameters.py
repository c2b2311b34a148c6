"""Parameters and constants: an order in which they can be computed, and their values.

*Evaluated* are those that no run can change: constants, Strings, `final` and structural parameters (those
with `annotation(Evaluate = true)`), if their values depend on evaluated ones only. Their values are put
into the equations, where a zero removes a term and a Boolean decides an `if`. All others stay symbols.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, field, replace

from acausal.errors import Diagnostic, LookupProblem, TypeProblem
from acausal.lang.flat import REAL, STRING, FlatModel, Variability, Variable
from acausal.symbolic.describe import SHOWN, place, quoted
from acausal.symbolic.expressions.evaluate import EvaluationFailed, NotConstant, evaluate
from acausal.symbolic.expressions.expr import Constant, Expr, symbols


@dataclass(frozen=True)
class ParameterValues:
    """Values of parameters and constants as far as they are known before initialisation."""

    order: tuple[str, ...]
    values: dict[str, Constant]
    warnings: tuple[Diagnostic, ...] = ()
    evaluated: dict[str, Constant] = field(default_factory=dict[str, Constant])
    """Those whose values take the place of their names in the equations, in `order`."""
    _memo: dict[Expr, Constant] = field(default_factory=dict[Expr, Constant], compare=False, repr=False)

    def lookup(self, name: str) -> Constant | None:
        """The value of a parameter; None for other names and for what initialisation must determine."""
        return self.values.get(name)

    def constant(self, expr: Expr) -> Constant | None:
        """The value of an expression in parameters; None if it needs anything else or cannot be computed."""
        try:
            return evaluate(expr, self.values.get, self._memo)
        except (NotConstant, EvaluationFailed):
            return None

    def number(self, expr: Expr) -> float | None:
        """`constant` as a float; None for strings and enumerations too."""
        value = self.constant(expr)
        return float(value) if isinstance(value, int | float) else None


def definition(variable: Variable) -> Expr | None:
    """What gives a parameter its value: its binding, else its start (Modelica 3.6, 8.6)."""
    return variable.binding if variable.binding is not None else variable.start


def order_parameters(flat: FlatModel) -> tuple[str, ...]:
    """Parameters and constants so that each one's definition uses earlier ones only; else as declared.

    The start value of a parameter that is not fixed counts as its definition.
    Depth-first, O(size of the definitions). Raises LookupProblem `parameter.cyclic` naming the cycle.
    """
    uses = {v.name: _uses(v, flat) for v in flat.parameters}
    done: dict[str, bool] = {}
    for root, needs in uses.items():
        if root in done:
            continue
        done[root] = False
        stack = [(root, iter(needs))]
        while stack:
            name, pending = stack[-1]
            for needed in pending:
                if needed not in done:
                    done[needed] = False
                    stack.append((needed, iter(uses[needed])))
                    break
                if not done[needed]:
                    path = [entry[0] for entry in stack]
                    raise _cyclic(flat, path[path.index(needed) :])
            else:
                stack.pop()
                del done[name]
                done[name] = True  # re-inserted, so that `done` lists names in order of completion
    return tuple(done)


def _uses(variable: Variable, flat: FlatModel) -> tuple[str, ...]:
    expr = definition(variable)
    if expr is None:
        return ()
    by_name = flat.by_name
    return tuple(name for name in symbols([expr]) if name in by_name and not by_name[name].is_unknown)


def _cyclic(flat: FlatModel, cycle: list[str]) -> LookupProblem:
    path = " -> ".join([*cycle, cycle[0]])
    return LookupProblem(
        [
            Diagnostic(
                "parameter.cyclic",
                f"the value of `{name}` depends on itself: {path}",
                flat.by_name[name].span,
                tuple(cycle),
                "give one of them a value that does not use the others",
            )
            for name in cycle
        ]
    )


def free_parameters(flat: FlatModel) -> tuple[Variable, ...]:
    """The parameters that the initial problem determines, as declared: those with `fixed = false`."""
    return tuple(v for v in flat.parameters if not v.is_fixed)


def dependent_parameters(flat: FlatModel, order: Collection[str]) -> tuple[Variable, ...]:
    """The parameters whose bindings depend on free ones, in `order`: determined at the start as well."""
    unknown = {v.name for v in free_parameters(flat)}
    found: list[Variable] = []
    for name in order if unknown else ():
        variable = flat.by_name[name]
        expr = definition(variable)
        if variable.is_fixed and expr is not None and not unknown.isdisjoint(symbols([expr])):
            unknown.add(name)
            found.append(variable)
    return tuple(found)


def parameter_values(flat: FlatModel, unevaluated: Collection[str] = ()) -> ParameterValues:
    """Order and evaluate all parameters and constants.

    Those with `fixed = false`, those named `unevaluated`, and what depends on them have no value yet.

    Raises LookupProblem `parameter.cyclic` and TypeProblem `parameter.no-value`, `parameter.out-of-range`.
    """
    order = order_parameters(flat)
    known = ParameterValues(order, {})
    without: list[Variable] = []
    warnings: list[Diagnostic] = []
    for name in order:
        variable = flat.by_name[name]
        if not variable.is_fixed:
            continue
        expr = definition(variable)
        if expr is None:
            without.append(variable)
            continue
        if variable.binding is None:
            warnings.append(_start_used(variable))
        value = known.constant(expr) if name not in unevaluated else None
        if value is not None:
            known.values[name] = value  # where there is none, the run says why when it computes the parameter
            if _is_evaluated(variable, expr, flat, known):
                known.evaluated[name] = float(value) if variable.type == REAL else value  # type: ignore[arg-type]  # a Real's value is a number
    wrong = list(_no_values(flat, without))
    wrong += [d for name in order for d in out_of_range(flat.by_name[name], known.values.get(name), known)]
    if wrong:
        raise TypeProblem(wrong)
    return replace(known, warnings=tuple(warnings))


def _is_evaluated(variable: Variable, expr: Expr, flat: FlatModel, known: ParameterValues) -> bool:
    """Whether no run can change the value."""
    kind = variable.variability is Variability.CONSTANT or variable.type == STRING
    closed = kind or variable.final or variable.structural
    return closed and all(name in known.evaluated for name in symbols([expr]) if name in flat.by_name)


def out_of_range(variable: Variable, value: Constant | None, known: ParameterValues) -> Iterator[Diagnostic]:
    """What is wrong with `value` by the `min` and `max` of its declaration (Modelica 3.6, 4.9.1)."""
    if isinstance(value, bool) or not isinstance(value, int | float):
        return
    for word, attribute, sign in (("below", "min", 1), ("above", "max", -1)):
        bound = variable.min if attribute == "min" else variable.max
        limit = None if bound is None else known.number(bound)
        if limit is not None and sign * (value - limit) < 0:
            yield Diagnostic(
                "parameter.out-of-range",
                f"`{variable.name}` = {value:g} is {word} its {attribute}imum {limit:g}",
                variable.value_span or variable.span,
                (variable.name,),
                f"give it a value that is not {word} {limit:g}",
            )


def _no_values(flat: FlatModel, variables: Sequence[Variable]) -> Iterator[Diagnostic]:
    """One diagnostic for each component whose parameters lack values, where it is declared."""
    owned: dict[str, list[Variable]] = {}
    for variable in variables:
        owner = flat.places.owner(variable.name)
        owned.setdefault(owner or variable.name, []).append(variable)
    for owner, held in owned.items():
        where = flat.places.components.get(owner)
        names = tuple(v.name for v in held)
        which = f"parameter {quoted(names)} has" if len(held) == 1 else f"parameters {quoted(names)} have"
        declared = "" if where is None else f" ({place(held[0].span)})"
        values = ", ".join([f"{name} = ..." for name in names[:SHOWN]])
        yield Diagnostic(
            "parameter.no-value",
            f"the {which} no value{declared}",
            where or held[0].span,
            names,
            f"give {'it one' if len(held) == 1 else 'them values'} in the declaration or set it: {values}",
        )


def _start_used(variable: Variable) -> Diagnostic:
    return Diagnostic(
        "parameter.start-used",
        f"the parameter `{variable.name}` has no value; its start value is used ({place(variable.span)})",
        variable.span,
        (variable.name,),
        "give it a value in its declaration",
        "warning",
    )
