"""Solves the initial problem: states, all other unknowns, free parameters and modes at the start time."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

import numpy as np

from acausal.codegen.functions import Code, state_leaves
from acausal.errors import Diagnostic, InitializationProblem, fail
from acausal.simulate import homotopy
from acausal.simulate.block_solvers import Walk
from acausal.simulate.call import call
from acausal.simulate.evaluator import Evaluator
from acausal.simulate.events import literal_modes, operators
from acausal.simulate.initial_errors import check_redundant, with_starts
from acausal.simulate.initial_modes import Switched, consistent_modes
from acausal.simulate.initial_warnings import initial_warnings
from acausal.simulate.inputs import Inputs, InputValue, bind_inputs
from acausal.simulate.matrices import Vector
from acausal.simulate.messages import leaf_name, some
from acausal.simulate.overrides import Override, parameter_overrides, parameter_values, start_values
from acausal.simulate.suspects import naming_suspects
from acausal.simulate.walk import Walked, walk
from acausal.symbolic.causal import Block
from acausal.symbolic.describe import base_name
from acausal.symbolic.expressions.expr import Expr, sym
from acausal.symbolic.expressions.text import to_text

_DELAY_PASSES = 50
_ROUNDING = 1e-12
"""A root this small beside its sides does not change its mode while the initial modes are searched."""


@dataclass(frozen=True)
class UsedStart:
    """A start value that was used, its value, and how (`fixed`, `assumed` or `guess`)."""

    name: str
    value: float
    reason: str


@dataclass(frozen=True)
class InitialPoint:
    """The solved initial problem. `evaluator` holds the parameters, inputs, modes and guesses of it."""

    evaluator: Evaluator
    time: float
    x: Vector
    used: tuple[UsedStart, ...]
    warnings: tuple[Diagnostic, ...] = ()
    """Blocks that only a homotopy could solve (`initialize.homotopy`)."""
    cpu_seconds: float = 0.0
    """What solving it took."""


def initialize(
    code: Code,
    time: float,
    parameters: Mapping[str, Override] | None = None,
    start: Mapping[str, float] | None = None,
    inputs: Mapping[str, InputValue] | None = None,
    until: float | None = None,
) -> InitialPoint:
    """The consistent initial point at `time`.

    `parameters` override bindings, `start` override start values, `inputs` give the model's inputs, whose
    tables must reach `until`. Raises `InitializationProblem`, and `UsageProblem` or `LookupProblem` for what
    cannot be given.
    """
    given, override = parameter_overrides(code, parameters or {})
    p = parameter_values(code, given, override)
    bound = bind_inputs(code, p, inputs or {}, time, time if until is None else until)
    problem = _Problem(code, time, p, bound, start_values(code, p, start or {}))
    changes = _Changes(parameters or {}, start or {})
    with naming_suspects(code, p):
        return _point(problem, changes, given, override)


def _point(problem: _Problem, changes: _Changes, given: Vector, override: Vector) -> InitialPoint:
    code, time, bound = problem.code, problem.time, problem.inputs
    walked, switched, notes = _solved(problem, lambda error: _by_homotopy(problem, changes, error))
    known = dict(zip(code.initial.slots, walked.values.tolist(), strict=True))
    for i, name in enumerate(code.system.parameters):
        if sym(name) in code.initial.unknowns:
            given[i], override[i] = known[sym(name)], 1.0
    evaluator = Evaluator(code, parameter_values(code, given, override), bound)
    evaluator.m[:], evaluator.d[:] = switched.m, switched.d
    evaluator.u[len(bound.constants) :] = problem.delayed
    evaluator.guess[:] = [known.get(leaf, 0.0) for leaf in code.dynamic.guesses]
    check_redundant(code, walked.values)
    x = np.array([known[leaf] for leaf in state_leaves(code.system)])
    reasons = code.system.initial.values
    used = tuple(UsedStart(v.name, float(s), v.reason) for v, s in zip(reasons, problem.starts, strict=True))
    continued = [_homotopy_used(block) for block in walked.continued]
    doubtful = initial_warnings(code, walked.values, evaluator.p)
    return InitialPoint(evaluator, time, x, used, (*notes, *continued, *doubtful))


@dataclass(frozen=True)
class _Changes:
    """What a run changes: parameters and start values."""

    parameters: Mapping[str, Override]
    start: Mapping[str, float]


_Solution = tuple[Walked, Switched, tuple[Diagnostic, ...]]


def _solved(problem: _Problem, otherwise: Callable[[InitializationProblem], _Solution]) -> _Solution:
    """Values, modes and what to report, from the start values; else as `otherwise` finds them."""
    try:
        return *consistent_modes(problem.code, problem.suggested(), problem), ()
    except InitializationProblem as error:
        named = with_starts(problem.code, error, problem.start_of)
        if problem.code.system.homotopy is None:
            raise named from None
        return otherwise(named)


def _by_homotopy(problem: _Problem, changes: _Changes, error: InitializationProblem) -> _Solution:
    """From the end of the path that begins at the simplified equations."""
    code = problem.code
    blend = homotopy.compiled_blend(code, error)
    given, override = parameter_overrides(blend, changes.parameters)
    used = {value.name for value in blend.system.initial.values}
    starts = {name: value for name, value in changes.start.items() if name in used}
    position = homotopy.lambda_leaf_position(blend)
    override[position] = 1.0

    def solve(weight: float, before: homotopy.PathPoint | None) -> homotopy.PathPoint:
        given[position] = weight
        p = parameter_values(blend, given, override)
        step = _Problem(blend, problem.time, p, problem.inputs, start_values(blend, p, starts))
        switched = step.suggested()
        if before is not None:
            step.guess_from(before.walked, local=True)
            switched = before.switched
        return homotopy.PathPoint(*consistent_modes(blend, switched, step))

    followed = homotopy.follow(code, blend, solve, error)
    problem.guess(followed.values)
    switched = homotopy.switched_like(code, problem.suggested(), followed.switched)
    found = consistent_modes(code, switched, problem)
    return *found, (homotopy.used(code, error, followed.steps),)


class _Problem:
    """The initial problem at one time with one set of parameters, inputs and start values."""

    def __init__(self, code: Code, time: float, p: Vector, inputs: Inputs, starts: Vector) -> None:
        self.code = code
        self.time = time
        self.inputs = inputs
        self._p = p
        self._u = np.concatenate([inputs.constants, np.zeros(len(code.system.delays))])
        inputs.fill(time, self._u)
        inputs.explain(time, self._u)
        self.starts = starts
        names = [value.name for value in code.system.initial.values]
        self.start_of = dict(zip(names, starts.tolist(), strict=True))
        self._how = Walk(InitializationProblem, time, _nominals(code, p), self.start_of)

    def guess(self, values: Mapping[str, float], *, local: bool = False) -> None:
        """Start the search from these values, by name."""
        self._how = replace(self._how, guess={**self._how.guess, **values}, local=local)

    def guess_from(self, walked: Walked, *, local: bool) -> None:
        """Start the search from another solution of the same problem."""
        slots = self.code.initial.slots
        self.guess(
            {leaf_name(leaf): float(walked.values[slots[leaf]]) for leaf in self.code.initial.unknowns},
            local=local,
        )

    def suggested(self) -> Switched:
        """Modes and frozen values with every variable at its start value."""
        time = np.array([self.time])
        roots = call(self.code.start_roots, time, self._p, self._u, self.starts)[0].ravel()
        modes = literal_modes(operators(self.code.system), np.nan_to_num(roots, nan=0.0))
        known = {value.name: i for i, value in enumerate(self.code.system.initial.values)}
        frozen = self.code.system.discrete.frozen
        d = [self.starts[known[n]] if (n := base_name(leaf)) in known else 0.0 for leaf in frozen]
        starting = [float(leaf.op == "initial") for leaf in frozen]
        return Switched(modes, np.where([leaf.op in ("sym", "pre") for leaf in frozen], d, starting))

    def implied(self, modes: Vector) -> Switched:
        """These modes with the discrete values that follow from them and the start values."""
        switched = replace(self.suggested(), m=modes)
        code, starts = self.code, self.start_of
        x = np.array([starts.get(leaf_name(leaf), 0.0) for leaf in state_leaves(code.system)])
        z = np.array([starts.get(leaf_name(leaf), 0.0) for leaf in code.dynamic.guesses])
        point = [np.array([self.time]), x, self._p, modes, self._u, switched.d, z]
        found = call(code.discrete.start, *point, self.starts)[0].ravel()
        known = np.flatnonzero(np.isfinite(found))
        switched.d[known] = found[known]
        return switched

    def solve(self, switched: Switched) -> Walked:
        """All values with these modes and frozen values."""
        delays = len(self.code.system.delays)
        for _ in range(_DELAY_PASSES if delays else 1):
            inputs = [np.array([self.time]), self._p, switched.m, self._u, switched.d, self.starts]
            walked = walk(self.code.initial, np.concatenate(inputs), self._how)
            if not delays:
                return walked
            point = self._point(switched, walked.values)
            present = call(self.code.discrete.delayed, *point)[0].ravel()
            before = self._u[-delays:].copy()
            self._u[-delays:] = present
            if np.allclose(before, present, rtol=1e-12, atol=0.0):
                return walked
        raise self._no_delayed()

    @property
    def delayed(self) -> Vector:
        """The delayed values at the start."""
        return self._u[len(self.inputs.constants) :]

    def _no_delayed(self) -> InitializationProblem:
        texts = [to_text(node) for node in self.code.system.delays]
        message = f"the initial values of {some(texts)} do not settle: each depends on itself"
        hint = "a loop through delays has no solution at the start, where a delayed value is the present one"
        return fail(InitializationProblem, "initialize.delay", message, hint=hint)

    def modes(self, switched: Switched, values: Vector) -> Vector:
        """The relations' values at the solution."""
        code, point = self.code, self._point(switched, values)
        roots, sizes = (call(f, *point)[0].ravel() for f in (code.events, code.sizes))
        rounded = (np.abs(roots) <= _ROUNDING * sizes) & (roots != 0)
        return np.where(rounded, switched.m, literal_modes(operators(code.system), roots))

    def frozen(self, switched: Switched, values: Vector) -> Vector:
        """The discrete values at the solution; those of samples and phases stay."""
        if not switched.d.size:
            return switched.d
        point = self._point(switched, values)
        found = call(self.code.discrete.start, *point, self.starts)[0].ravel()
        return np.concatenate([found, switched.d[len(found) :]])

    def _point(self, switched: Switched, values: Vector) -> list[Vector]:
        """The inputs of the dynamic Functions at the solution."""
        code, slots = self.code, self.code.initial.slots
        x = values[[slots[leaf] for leaf in state_leaves(code.system)]]
        z = np.array([values[slots[leaf]] if leaf in slots else 0.0 for leaf in code.dynamic.guesses])
        p = values[[slots[sym(name)] for name in code.system.parameters]]
        return [np.array([self.time]), x, p, switched.m, self._u, switched.d, z]


def _nominals(code: Code, p: Vector) -> dict[Expr, float]:
    states, guesses = (column.ravel().tolist() for column in call(code.nominals, p))
    known = dict(zip(state_leaves(code.system), states, strict=True))
    return known | dict(zip(code.dynamic.guesses, guesses, strict=True))


def _homotopy_used(block: Block) -> Diagnostic:
    names = [leaf_name(leaf) for leaf in block.tearing]
    return Diagnostic(
        "initialize.homotopy",
        f"the initial values of {some(names)} were found by a homotopy only: the start values are far away",
        block.residuals[0].equation.flat.span,
        tuple(names),
        "give better start values",
        "warning",
    )
