"""Dynamic state selection: other states, chosen where those in use no longer fit.

A point mass on a circle can be described by x near the top and by y at the sides, and by neither everywhere.
`CausalSystem.dynamic` says what to watch; its monitors are zero crossings, so every solver locates the
instant at which the choice has become bad. The run then stops, `choose_states` chooses at the present
values, and the system with these states goes on from there. All values, those of the new states included,
come from the old system at this very instant, so constraints and invariants stay as exact as they were.

Feehery and Barton, "Dynamic optimization with state variable path constraints", Comput. Chem. Eng. 20
(1996), and Mattsson, Olsson and Elmqvist, "Dynamic selection of states in Dymola", Modelica Workshop 2000,
pivot the dummy derivatives in the same way.
"""

from __future__ import annotations

from collections import deque
from time import process_time
from weakref import WeakKeyDictionary

import numpy as np

from acausal.codegen.functions import Code, generate
from acausal.errors import AcausalError, SimulationProblem, fail
from acausal.simulate.evaluator import Evaluator
from acausal.simulate.matrices import Vector
from acausal.simulate.messages import at, some
from acausal.symbolic.causal import DynamicStates
from acausal.symbolic.causalise import choose_states, with_states
from acausal.symbolic.describe import equation_with_place
from acausal.symbolic.expressions.expr import Expr
from acausal.symbolic.expressions.text import to_text

MOST_CHOICES = 50
SHARE = 1e-6
"""This many choices within this share of the simulated time are too many."""

_Key = tuple[tuple[Expr, ...], tuple[Expr, ...]]
"""The states, and the relations of the monitors."""

_variants: WeakKeyDictionary[DynamicStates, dict[_Key, Code]] = WeakKeyDictionary()
"""Compiled systems by the choice they belong to, shared by all runs of a model while it lives."""


class Reselection:
    """The choices of states of one run."""

    def __init__(self, evaluator: Evaluator, span: float) -> None:
        self.count = 0
        self.compiling = 0.0
        """CPU seconds spent on compiling systems, which is no part of the run."""
        self._origin = evaluator.code
        self._span = span
        self._recent: deque[float] = deque(maxlen=MOST_CHOICES)

    def own(self, evaluator: Evaluator) -> int:
        """How many of the evaluator's modes belong to the model; the rest watch the choice of states."""
        return len(evaluator.code.system.events)

    def is_due(self, evaluator: Evaluator) -> bool:
        """Whether a monitor's relation is false."""
        return not bool(evaluator.m[self.own(evaluator) :].all())

    def __call__(self, evaluator: Evaluator, time: float, x: Vector) -> tuple[Evaluator, Vector]:
        """The evaluator of the system with states chosen anew, and their values.

        Raises ReductionProblem where the constraints have become dependent, `SimulationProblem`
        (`simulate.state-selection`) where choices accumulate.
        """
        evaluator.at(time, x)
        evaluator.settle()
        values = _present(evaluator)
        self._count(evaluator, time)
        code = self._variant(evaluator, values)
        renewed = Evaluator(code, evaluator.p, evaluator.inputs)
        own = self.own(evaluator)
        renewed.m[:] = 1.0
        renewed.m[:own] = evaluator.m[:own]
        renewed.d[:] = evaluator.d
        renewed.u[:], renewed.history, renewed.jumps = evaluator.u, evaluator.history, evaluator.jumps
        renewed.guess[:] = [values.get(to_text(leaf), 0.0) for leaf in code.dynamic.guesses]
        return renewed, np.array([values[name] for name in code.system.states])

    def _variant(self, evaluator: Evaluator, values: dict[str, float]) -> Code:
        system = self._origin.system
        assert system.dynamic is not None
        chosen = choose_states(system, evaluator.code.system.states, values)
        known = _variants.setdefault(system.dynamic, {})
        key = (chosen.states, tuple(monitor.relation for monitor in chosen.monitors))
        if key not in known:
            began = process_time()
            known[key] = generate(with_states(system, chosen))
            self.compiling += process_time() - began
        return known[key]

    def _count(self, evaluator: Evaluator, time: float) -> None:
        self.count += 1
        self._recent.append(time)
        first = self._recent[0]
        if len(self._recent) == MOST_CHOICES and time - first <= SHARE * self._span:
            raise _too_many(evaluator, time, first)


def _present(evaluator: Evaluator) -> dict[str, float]:
    """Every value at the evaluator's point, by name."""
    evaluator.output()
    unknowns = map(to_text, evaluator.code.output_leaves)
    return {
        "time": float(evaluator.t[0]),
        **dict(zip(evaluator.code.system.parameters, evaluator.p.tolist(), strict=True)),
        **dict(zip(unknowns, evaluator.output.outputs[0].tolist(), strict=True)),
    }


def _too_many(evaluator: Evaluator, time: float, first: float) -> AcausalError:
    dynamic = evaluator.code.system.dynamic
    monitors = dynamic.monitors if dynamic is not None else ()
    constraints = dict.fromkeys(equation_with_place(c.flat) for m in monitors for c in m.constraints)
    names = dict.fromkeys(n for m in monitors for n in (*m.solved_for, *m.alternatives))
    return fail(
        SimulationProblem,
        "simulate.state-selection",
        f"states were chosen anew {MOST_CHOICES} times within {time - first:.3g} s {at(time)}: "
        f"no choice among {some(list(names))} lets the constraints {some(list(constraints))} be solved",
        next((m.constraints[0].flat.span for m in monitors), None),
        names=names,
        hint="the constraints become dependent here (a dead centre, a mechanism stretched out): "
        "make one of them elastic, or keep the motion away from this point",
    )
