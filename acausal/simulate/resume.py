"""The point from which a run goes on where another one stood."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from acausal.codegen.functions import Code
from acausal.errors import UsageProblem, fail
from acausal.simulate.evaluator import Evaluator
from acausal.simulate.events import literal_modes, operators
from acausal.simulate.initialize import InitialPoint
from acausal.simulate.inputs import InputValue, bind_inputs
from acausal.simulate.messages import some
from acausal.simulate.overrides import Override, parameter_overrides, parameter_values
from acausal.simulate.standing import Standing
from acausal.symbolic.expressions.text import to_text


def resume(
    code: Code,
    after: Standing,
    parameters: Mapping[str, Override] | None,
    inputs: Mapping[str, InputValue] | None,
    until: float,
) -> InitialPoint:
    """The point at which `after` stands, with the parameters and inputs of this run.

    Raises `UsageProblem` (`usage.continue`) where the stored run does not fit the model.
    """
    _check(code, after)
    given, override = parameter_overrides(code, parameters or {})
    position = {name: i for i, name in enumerate(code.system.parameters)}
    for name, value in after.parameters.items():
        given[position[name]], override[position[name]] = value, 1.0
    p = parameter_values(code, given, override)
    evaluator = Evaluator(code, p, bind_inputs(code, p, inputs or {}, after.time, until))
    evaluator.d[:] = [after.frozen[to_text(leaf)] for leaf in code.system.discrete.frozen]
    known = {**after.states, **after.guesses}
    evaluator.guess[:] = [known.get(to_text(leaf), 0.0) for leaf in code.dynamic.guesses]
    if evaluator.history is not None:
        for sample in after.past:
            evaluator.history.add(sample)
    x = np.array([after.states[name] for name in code.system.states])
    own = len(after.modes)
    evaluator.m[:own] = after.modes
    if own < evaluator.m.size:
        evaluator.m[own:] = 1.0
        evaluator.at(after.time, x)
        evaluator.settle()
        evaluator.event()
        evaluator.m[own:] = literal_modes(operators(code.system), evaluator.roots)[own:]
    return InitialPoint(evaluator, after.time, x, ())


def _check(code: Code, after: Standing) -> None:
    system = code.system
    known = {"states": system.states, "discrete values": tuple(map(to_text, system.discrete.frozen))}
    if after.model != system.flat.name:
        why = f"it is of `{after.model}`, not of `{system.flat.name}`"
    elif missing := [name for name in known["states"] if name not in after.states]:
        why = f"it lacks the states {some(missing)}"
    elif missing := [name for name in known["discrete values"] if name not in after.frozen]:
        why = f"it lacks the discrete values {some(missing)}"
    elif len(after.modes) != len(system.events) or len(after.samples) != len(system.discrete.samples):
        why = "its events are others"
    elif unknown := [name for name in after.parameters if name not in system.parameters]:
        why = f"the model has no parameters {some(unknown)}"
    else:
        return
    hint = "continue with the model, the parameters and the version of acausal that wrote it"
    raise fail(UsageProblem, "usage.continue", f"the stored run cannot be continued: {why}", hint=hint)
