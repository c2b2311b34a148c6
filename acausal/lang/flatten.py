"""From the instance tree to the FlatModel: every variable and equation as scalars, connections resolved."""

from __future__ import annotations

from dataclasses import replace

from acausal.lang.connections import check_constants, connection_equations
from acausal.lang.equations import Equations
from acausal.lang.experiment import experiment_of
from acausal.lang.flat import FlatModel, Variable
from acausal.lang.flat_variables import Variables
from acausal.lang.instance import Array, Instance, Leaf, Member, Outer
from acausal.lang.translate import Translator
from acausal.symbolic.expressions import expr as ex


def flatten(translator: Translator, root: Instance) -> FlatModel:
    """The FlatModel of a complete instance tree. Raises what its expressions and equations raise."""
    variables = Variables(translator)
    found = variables.of(root)
    work = Equations(translator)
    for instance in _components(root):
        work.component(instance)
    constants = dict.fromkeys(leaf.path for a, b, _ in work.sets.constants for leaf in (a, b))
    values = {
        path: translator.evaluate_expr(ex.sym(path), root.scope.span, f"the connected parameter `{path}`")
        for path in constants
    }
    check_constants(work.sets, values)
    return FlatModel(
        name=root.scope.path,
        description=root.description,
        variables=_marked(translator, found),
        equations=(*variables.bindings, *work.equations, *connection_equations(work.sets, root)),
        initial_equations=tuple(work.initial),
        assertions=tuple(work.assertions),
        experiment=experiment_of(translator, root.scope),
        span=root.scope.span,
        warnings=tuple(translator.warnings),
    )


def _components(root: Instance) -> list[Instance]:
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
    return found


def _marked(translator: Translator, variables: list[Variable]) -> tuple[Variable, ...]:
    """The variables, with those marked as structural whose values shaped the model or are to be evaluated."""
    for variable in variables:
        if variable.structural:
            translator.mark_evaluated(variable.name)
    structural = translator.structural
    return tuple([replace(v, structural=True) if v.name in structural else v for v in variables])
