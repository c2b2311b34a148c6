"""From the instance tree to the FlatModel: every variable and equation as scalars, connections resolved."""

from __future__ import annotations

from dataclasses import replace

from acausal.lang.assertions import without_repetitions
from acausal.lang.connection_constraints import constraint_equations
from acausal.lang.connections import ConnectionSets, check_constants, check_quantities, connection_equations
from acausal.lang.equations import Equations
from acausal.lang.experiment import experiment_of
from acausal.lang.flat import FlatModel, Variable
from acausal.lang.flat_variables import Variables
from acausal.lang.instance import Instance
from acausal.lang.links import components
from acausal.lang.places import places_of
from acausal.lang.streams import Streams
from acausal.lang.translate import Translator
from acausal.symbolic.expressions import expr as ex


def flatten(translator: Translator, root: Instance) -> FlatModel:
    """The FlatModel of a complete instance tree. Raises what its expressions and equations raise."""
    network = translator.start(root)
    sets = ConnectionSets(in_buses=network.expansion.inside, added_flows=network.expansion.added_flows)
    if network.overdetermined:
        sets.overdetermined = network.overdetermined
        sets.broken = network.graph(root.scope.span).broken
    work = Equations(translator, sets)
    variables = Variables(translator)
    found = variables.of(root)
    for instance in components(root):
        work.component(instance)
    constants = dict.fromkeys(leaf.path for a, b, _ in work.sets.constants for leaf in (a, b))
    values = {
        path: translator.evaluate_expr(ex.sym(path), root.scope.span, f"the connected parameter `{path}`")
        for path in constants
    }
    check_constants(work.sets, values)
    check_quantities(sets, {v.name: v.quantity for v in found if v.quantity})
    constraints = constraint_equations(translator, sets, network.overdetermined, root)
    streams = Streams(translator, sets, network.flows(), tuple(network.asked))
    equations = streams.resolved(
        (
            *variables.bindings,
            *work.equations,
            *connection_equations(work.sets, root),
            *streams.equations(),
            *constraints,
        )
    )
    work.discrete.check_left_limits(translator.left_limits, found)
    work.discrete.check_states(equations)
    work.discrete.check_declared(found, equations)
    return FlatModel(
        name=root.scope.path,
        description=root.description,
        variables=tuple([work.discrete.mark(v) for v in _marked(translator, found)]),
        equations=equations,
        initial_equations=streams.resolved(work.initial),
        assertions=streams.resolved(without_repetitions(translator.assertions)),
        experiment=experiment_of(translator, root.scope),
        span=root.scope.span,
        warnings=tuple(translator.warnings),
        whens=streams.resolved(work.whens),
        declared_units=tuple(translator.declared_units.items()),
        open_inputs=frozenset(path for path in variables.inputs if not sets.joins(path)),
        places=places_of(root),
    )


def _marked(translator: Translator, variables: list[Variable]) -> tuple[Variable, ...]:
    """The variables, with those marked as structural whose values shaped the model or are to be evaluated."""
    for variable in variables:
        if variable.structural:
            translator.mark_evaluated(variable.name)
    structural = translator.structural
    return tuple([replace(v, structural=True) if v.name in structural else v for v in variables])
