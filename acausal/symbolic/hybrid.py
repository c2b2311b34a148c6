"""Everything that happens at events, put together: zero crossings, discrete part, delays."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from acausal.errors import InitializationProblem, fail
from acausal.lang.flat import Assertion
from acausal.symbolic.alias import Simplified
from acausal.symbolic.causal import Check, DiscretePart, Reset, Stop, ZeroCrossing
from acausal.symbolic.discrete import Divided, discrete_part
from acausal.symbolic.discrete_initial import DiscreteStart, discrete_start
from acausal.symbolic.events import switches
from acausal.symbolic.expressions.expr import Expr, neg, postorder, sym
from acausal.symbolic.index_reduction import Reduced
from acausal.symbolic.leaves import Rewriter
from acausal.symbolic.when_clauses import Lowered


@dataclass(frozen=True)
class Hybrid:
    """What changes at events, and when events are."""

    crossings: tuple[ZeroCrossing, ...]
    discrete: DiscretePart
    delays: tuple[Expr, ...]
    start: DiscreteStart


def hybrid_part(reduced: Reduced, divided: Divided, lowered: Lowered) -> Hybrid:
    """Zero crossings, sorted discrete equations and actions of a model. Near-linear.

    Raises TypeProblem `type.real-equality` and InitializationProblem.
    """
    model = reduced.model
    actions = _rewritten(lowered, model)
    definitions = [d.equation for d in divided.definitions]
    conditions = [(r.condition, r.span) for r in actions.resets]
    conditions += [(c.condition, c.assertion.span) for c in actions.checks]
    conditions += [(s.condition, s.termination.span) for s in actions.stops]
    conditions += [(a.condition, a.span) for a in model.assertions]
    found = switches([*reduced.equations, *definitions], conditions, reduced.chains)
    equations = [*reduced.equations, *definitions, *model.initial_equations, *divided.initial]
    everything = [side for e in equations for side in (e.left, e.right)]
    everything += [*actions.roots, *(a.condition for a in model.assertions)]
    part = discrete_part(divided.definitions, found.holders, everything)
    part = replace(part, resets=actions.resets, checks=actions.checks, stops=actions.stops)
    start = discrete_start(divided, part)
    delays = tuple([node for node in postorder(everything) if node.op == "delay"])
    return Hybrid(found.crossings, replace(part, initial=start.assignments), delays, start)


def _rewritten(lowered: Lowered, model: Simplified) -> Lowered:
    """The actions in the variables that are left after alias elimination."""
    if not (lowered.resets or lowered.checks or lowered.stops):
        return lowered
    mapping = {sym(alias.name): alias.value for alias in model.aliases}
    rewrite = Rewriter(mapping, model.chains(), model.values.lookup)
    return replace(
        lowered,
        resets=tuple([_reset(reset, rewrite) for reset in lowered.resets]),
        checks=tuple([Check(rewrite(c.condition), _assertion(c.assertion, rewrite)) for c in lowered.checks]),
        stops=tuple([Stop(rewrite(s.condition), s.termination) for s in lowered.stops]),
    )


def _reset(reset: Reset, rewrite: Rewriter) -> Reset:
    state, value = rewrite(sym(reset.state)), rewrite(reset.value)
    if state.op == "neg":
        state, value = state.args[0], neg(value)
    if state.op != "sym":
        raise fail(
            InitializationProblem,
            "reinit.no-state",
            f"`{reset.state}` cannot be reinitialised: it has a fixed value",
            reset.span,
            names=[reset.state],
        )
    return replace(reset, condition=rewrite(reset.condition), state=state.name, value=value)


def _assertion(assertion: Assertion, rewrite: Rewriter) -> Assertion:
    return replace(assertion, condition=rewrite(assertion.condition))


def reset_names(resets: Sequence[Reset]) -> tuple[str, ...]:
    """The states that events change, each once."""
    return tuple(dict.fromkeys([reset.state for reset in resets]))
