"""The symbolic core on one screen: FlatModel in, CausalSystem out."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace

from acausal.errors import Diagnostic, ReductionProblem
from acausal.lang.flat import FlatModel
from acausal.symbolic.alias import NamedDerivative, Simplified, eliminate_aliases
from acausal.symbolic.balance import check_balance
from acausal.symbolic.blocks import NoCompleteMatching, ordered_blocks, square_system
from acausal.symbolic.causal import (
    Assignment,
    Block,
    BlockKind,
    CausalSystem,
    DynamicStates,
    InitialProblem,
    StateMonitor,
    ZeroCrossing,
)
from acausal.symbolic.derivative_states import name_derivative_states
from acausal.symbolic.describe import equation_with_place, leaf_texts, listed
from acausal.symbolic.discrete import divide
from acausal.symbolic.discrete_initial import DiscreteStart
from acausal.symbolic.expressions.expr import der, sym
from acausal.symbolic.expressions.text import to_text
from acausal.symbolic.hidden_constraints import reveal_constraints
from acausal.symbolic.hybrid import Hybrid, hybrid_part
from acausal.symbolic.index_reduction import Reduced, reduce_index
from acausal.symbolic.initial import initial_problem
from acausal.symbolic.outputs import keep_for_outputs
from acausal.symbolic.parameters import parameter_values
from acausal.symbolic.solving import Profiler
from acausal.symbolic.state_selection import Point, SelectedStates, select_states, starting_point
from acausal.symbolic.strings import refuse_strings, with_decided_strings
from acausal.symbolic.when_clauses import lower


def causalise(
    flat: FlatModel, outputs: Sequence[str] | None = None, *, unevaluated: Collection[str] = ()
) -> CausalSystem:
    """Choose states, order and tear the equations, and set up the initial problem.

    With `outputs`, only of the part of the model that these need (`outputs.keep_for_outputs`). The values of
    the parameters `unevaluated` are not used. Time grows near-linearly with the model. Raises
    BalanceProblem, ReductionProblem, InitializationProblem, LookupProblem (`parameter.cyclic`) and
    TypeProblem (`parameter.no-value`, `type.real-equality`).
    """
    if outputs is not None:
        part, removed = keep_for_outputs(flat, outputs)
        return replace(causalise(part, unevaluated=unevaluated), removed=removed)
    check_balance(flat)
    lowered = lower(flat)
    known = with_decided_strings(lowered.flat)
    model = eliminate_aliases(known, parameter_values(known, unevaluated))
    refuse_strings(model)
    divided = divide(model, Profiler(model.values, model.flat.by_name))
    reduced = reduce_index(reveal_constraints(divided.continuous))
    hybrid = hybrid_part(reduced, divided, lowered)
    selected = select_states(reduced, starting_point(reduced))
    system = _assembled(reduced, selected, hybrid, with_initial=True)
    return replace(system, homotopy=flat) if model.has_homotopy else system


def choose_states(
    system: CausalSystem, states: Sequence[str], present: Mapping[str, float]
) -> SelectedStates:
    """Other states than `states`, chosen at the `present` values of time, unknowns and parameters.

    Raises ReductionProblem where the constraints became dependent.
    """
    assert system.dynamic is not None
    reduced = system.dynamic.reduced
    known = {leaf: present[name] for leaf in reduced.leaves if (name := to_text(leaf)) in present}
    given = {sym(name): present[name] for name in (*system.parameters, "time") if name in present}
    return select_states(reduced, Point({**known, **given}, tuple(states)))


def with_states(system: CausalSystem, chosen: SelectedStates) -> CausalSystem:
    """`system` with states as `choose_states` gave them, and without initial problem.

    It has the same zero crossings but for the monitors, and determines the same unknowns.
    """
    assert system.dynamic is not None
    hybrid = Hybrid(system.events, system.discrete, system.delays, DiscreteStart((), ()))
    return _assembled(system.dynamic.reduced, chosen, hybrid, with_initial=False)


def _assembled(
    origin: Reduced, selection: SelectedStates, hybrid: Hybrid, *, with_initial: bool
) -> CausalSystem:
    """The causal system of one selection. Where others may follow, all determine the same derivatives."""
    reduced, selected = name_derivative_states(origin, selection)
    model = reduced.model
    states = tuple(leaf.name for leaf in selected.states)
    profiler = Profiler(model.values, model.flat.by_name)
    blocks = _running_blocks(reduced, selected, profiler)
    chosen = set(states)
    several = bool(selected.monitors) or not with_initial
    named = [entry for entry in model.named if several or entry.of in chosen]
    initial = InitialProblem((), ())
    if with_initial:
        initial = initial_problem(reduced, states, blocks, profiler)
        initial = replace(initial, values=(*initial.values, *hybrid.start.values))
    return CausalSystem(
        flat=model.flat,
        parameters=model.values.order,
        aliases=model.aliases,
        equations=(*reduced.equations, *(entry.equation for entry in named), *hybrid.discrete.equations),
        states=states,
        dummy_derivatives=selected.dummies,
        index=differential_index(model, reduced, blocks, selected),
        blocks=(*blocks, *_derivative_assignments(named)),
        zero_crossings=(*hybrid.crossings, *(_watched(monitor) for monitor in selected.monitors)),
        assertions=model.assertions,
        initial=initial,
        choices=selected.choices,
        dynamic=DynamicStates(selected.monitors, origin) if selected.monitors else None,
        evaluated=tuple(model.values.evaluated),
        discrete=hybrid.discrete,
        delays=hybrid.delays,
    )


def _watched(monitor: StateMonitor) -> ZeroCrossing:
    equation = monitor.constraints[0]
    return ZeroCrossing(monitor.relation, equation, equation.flat.span)


def _running_blocks(reduced: Reduced, selected: SelectedStates, profiler: Profiler) -> tuple[Block, ...]:
    """Blocks that give everything but the states. Raises ReductionProblem `reduction.singular`."""
    known = set(selected.states)
    unknowns = [leaf for leaf in reduced.leaves if leaf not in known]
    try:
        square = square_system([profiler.profile(e) for e in reduced.equations], unknowns)
    except NoCompleteMatching as problem:
        raise _singular(reduced, problem) from None
    return ordered_blocks(square)


def _singular(reduced: Reduced, problem: NoCompleteMatching) -> ReductionProblem:
    square = problem.square
    free = leaf_texts(square.unknowns[var] for var in square.matching.unmatched_variables())
    surplus = [square.profiles[eq].equation.flat for eq in square.matching.unmatched_equations()]
    span = surplus[0].span if surplus else reduced.model.flat.span
    message = f"after index reduction the equations of the running system do not determine {listed(free)}"
    if surplus:
        message += f", and {listed([equation_with_place(e) for e in surplus])} determines nothing"
    hint = "terms of these equations cancel: one of them follows from the others"
    return ReductionProblem(Diagnostic("reduction.singular", message, span, free, hint))


def _derivative_assignments(named: Sequence[NamedDerivative]) -> list[Block]:
    """`der(x) := v` for the states whose derivative has a name, so that every state's derivative is there."""
    return [
        Block(BlockKind.EXPLICIT, (Assignment(der(sym(entry.of)), sym(entry.derivative), entry.equation),))
        for entry in named
    ]


def differential_index(
    model: Simplified, reduced: Reduced, blocks: Sequence[Block], selected: SelectedStates
) -> int:
    """0 for an explicit ODE, 1 with algebraic parts, one more for every level of differentiation.

    Differentiations that alias elimination did silently (two rigidly connected masses) count too.
    """
    levels = max((model.differentiations, *reduced.reduction.differentiations))
    if levels:
        return 1 + levels
    slopes = {reduced.chains.derivative(leaf) for leaf in selected.states}
    algebraic = any(unknown not in slopes for block in blocks for unknown in block.unknowns)
    return 1 if algebraic else 0
