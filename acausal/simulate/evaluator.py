"""The compiled Functions bound to arrays: no allocation, no CasADi matrices, under a microsecond per call.

`casadi.Function.buffer` evaluates on memory that is handed over once; all Functions share the same inputs,
so a callback copies time and states in, evaluates, and copies the result out.

Implicit blocks are solved once per point: `ode` does it, and what else is asked for at the same time, states
and modes (events, outputs, conditions) uses its solution; `codegen.stitch` gives the measurement.
"""

from __future__ import annotations

import ctypes
from contextlib import suppress

import numpy as np
from numpy.typing import NDArray

from acausal.codegen.functions import Code, state_leaves
from acausal.codegen.program import ImplicitCode
from acausal.errors import SimulationProblem
from acausal.simulate.block_solvers import Walk
from acausal.simulate.buffered import Buffered, Robust
from acausal.simulate.call import call
from acausal.simulate.history import History, Sample
from acausal.simulate.inputs import Inputs
from acausal.simulate.jumps import Jumps
from acausal.simulate.matrices import Vector
from acausal.simulate.messages import leaf_name
from acausal.simulate.turns import turns_between
from acausal.simulate.walk import Walked, walk
from acausal.simulate.walks import Walks
from acausal.symbolic.expressions.expr import Expr, der

HYSTERESIS = 1e-10
"""A root that rests and is this small beside both sides of its relation is zero."""
_CLEAR, _REST = 1e-11, 0.1
_ROUNDING = 1e-13


class Evaluator:
    """Numbers of one run, which the Functions read in place: parameters, inputs, modes, frozen values."""

    def __init__(self, code: Code, parameters: Vector, inputs: Inputs | None = None) -> None:
        self.code = code
        self.inputs = inputs if inputs is not None else Inputs(np.zeros(len(code.system.flat.inputs)))
        self.t = np.zeros(1)
        self.x = np.zeros(len(code.system.states))
        self.p = parameters.copy()
        self.m = np.zeros(len(code.system.zero_crossings))
        self.d = np.zeros(len(code.system.discrete.frozen))
        self.u = np.concatenate([self.inputs.constants, np.zeros(len(code.system.delays))])
        self.located = np.array(code.located, dtype=np.intp)
        self.shift = np.zeros(len(code.located))
        """What integrators add to the located roots, see `hold`."""
        self._above = np.array([code.relations[i].op in ("gt", "ge") for i in code.located], dtype=np.bool_)
        self.band = np.full(len(code.located), 0.1)
        """The largest sum of both sides' absolute values so far, of each located root."""
        self.guess = np.zeros(len(code.dynamic.guesses))
        self._moving = bool(self.inputs.moving)
        self.settled_z = self.guess.copy()
        """The solution of the blocks at the last event."""
        self.walks = Walks()
        self.jumps = Jumps()
        self._solved: tuple[float, bytes, bytes, bytes] | None = None
        nominal = call(code.nominals, self.p)
        self.x_nominal = _positive(nominal[0].ravel())
        self.z_nominal = _positive(nominal[1].ravel())
        known = [self.t, self.x, self.p, self.m, self.u, self.d]
        robust, quick = Robust(code, [*known, self.guess]), code.quick
        self.w = np.zeros(0) if quick.factors is None else call(quick.factors, self.p)[0].ravel()
        factors = [self.w] if quick.factors is not None else []
        begin = [*known, self.guess, *factors]
        self.ode = Buffered(quick.ode or code.ode, begin, rescue=quick.ode and robust.ode)
        self.xdot, self.z = self.ode.outputs
        given, before = [*known, self.z], self.solve if self.guess.size else None
        self.jac = (
            Buffered(code.jac, [*known, self.guess])
            if quick.slopes is None
            else Buffered(
                quick.slopes, [*given, *factors], before, robust.slopes if self.guess.size else None
            )
        )
        self.output = Buffered(code.outputs, given, before)
        self.event = Buffered(code.events, given, before if code.events_need_blocks else None)
        self.size = Buffered(code.sizes, given, before)
        self.condition = Buffered(code.conditions, given, before)
        self.update = Buffered(code.discrete.update, given, before)
        self.memory = Buffered(code.discrete.memory, given, before)
        self.actions = Buffered(code.discrete.actions, given, before)
        self.history = History(code.system, steady=code.delays_are_steady) if code.system.delays else None
        """The past of delayed expressions."""
        self.delayed = Buffered(code.discrete.delayed, given, before)
        self.roots = self.event.outputs[0]
        self.sizes = self.size.outputs[0]
        self.jacobian = self.jac.outputs[0]
        self.instant = Buffered(code.instants, [self.p, self.d])
        self.instants = self.instant.outputs[0]

    def compile(self, library: ctypes.CDLL) -> None:
        """Evaluates by the compiled functions of a library from now on, those that it has."""
        functions = (self.ode, self.jac, self.output, self.event, self.size, self.condition)
        for function in (*functions, self.update, self.memory, self.actions):
            function.compile(library)

    @property
    def groups(self) -> dict[str, Vector]:
        """The Functions' inputs by name, without the point and the tearing variables."""
        return {"p": self.p, "m": self.m, "u": self.u, "d": self.d, "w": self.w}

    @property
    def is_moving(self) -> bool:
        """Whether an input or a delayed value changes with time."""
        return self._moving or self.history is not None

    def refill(self, time: float) -> None:
        """Writes the inputs' and delayed values at `time`."""
        if self._moving:
            self.inputs.fill(time, self.u)
        if self.history is not None:
            self.history.fill(time, self.u[len(self.inputs.constants) :])

    def at(self, time: float, x: Vector) -> None:
        """Sets the point at which the Functions evaluate."""
        self.t[0] = time
        self.x[:] = x
        if self._moving or self.history is not None:
            self.refill(time)

    def keep_past(self, ahead: float) -> None:
        """Notes the delayed expressions at the present point, with their slopes over the time `ahead`."""
        if self.history is None:
            return
        time, x = float(self.t[0]), self.x.copy()
        self.delayed()
        values, lags, longest = [array.copy() for array in self.delayed.outputs]
        self.solve()
        self.at(time + ahead, x + ahead * self.xdot)
        self.delayed()
        later = self.delayed.outputs
        slopes = (later[0] - values) / ahead, (later[1] - lags) / ahead
        self.history.add(Sample(time, values, lags, longest, *slopes))
        self.at(time, x)

    def hold(self, ahead: float) -> None:
        """Sets `shift`, so that a crossing that was just handled is not found again, and rest makes no event.

        A located root that is zero or on the wrong side of its mode at the present point is shifted back; one
        that rests there, as it does not change in steps of `ahead`, by `HYSTERESIS` of the largest sum of
        both sides' absolute values met so far (at least of 0.1).
        """
        if not self.located.size:
            return
        self.event()
        self.size()
        roots, sizes = self.roots[self.located], self.sizes[self.located]
        if not np.isfinite(sizes).all():
            sizes = np.nan_to_num(sizes, posinf=0.0)
        np.maximum(self.band, sizes, out=self.band)
        side = np.where(self._above == (self.m[self.located] != 0.0), 1.0, -1.0)
        band = HYSTERESIS * self.band
        slack = np.where(side * roots > _CLEAR * sizes, 0.0, np.maximum(1.01 * np.abs(roots), 1e-9 * sizes))
        if (np.abs(roots) <= band).any():
            rests = (np.abs(roots) <= band) & (np.abs(self._later(ahead) - roots) <= _REST * band)
            slack = np.where(rests, np.maximum(slack, band), slack)
        self.shift[:] = side * slack

    def _later(self, ahead: float) -> Vector:
        """The located roots after two steps along the derivatives: what turns round does not rest."""
        time, x = float(self.t[0]), self.x.copy()
        for i in (1, 2):
            self.solve()
            self.at(time + i * ahead, self.x + ahead * self.xdot)
        self.event()
        later = self.roots[self.located].copy()
        self.at(time, x)
        return later

    def is_zero(self, roots: Vector, band: float) -> NDArray[np.bool_]:
        """Which located roots are smaller than `band`, relative to the largest sides met so far."""
        result = np.zeros(len(roots), dtype=np.bool_)
        result[self.located] = np.abs(roots[self.located]) <= band * self.band
        return result

    def within(self, roots: Vector) -> NDArray[np.bool_]:
        """Which roots are too close to zero to say that a relation lost its mode.

        That is within the shift of `hold`, or within the rounding of the largest size met so far: a root that
        is solved for, as the path parameter of a diode is, has the rounding of all that is solved with it.
        """
        result = np.zeros(len(roots), dtype=np.bool_)
        close = np.maximum(np.abs(self.shift), _ROUNDING * self.band)
        result[self.located] = np.abs(roots[self.located]) <= close
        return result

    def crossings(self, out: Vector) -> None:
        """The located roots, shifted, at the present point: what integrators watch for sign changes."""
        self.event()
        np.add(self.roots[self.located], self.shift, out=out)

    def solve(self) -> None:
        """Derivatives and solved blocks at the present point, unless they are known already."""
        if not self.guess.size:
            self.ode()
        elif self._solved != self._point():
            self.evaluate()

    def _point(self) -> tuple[float, bytes, bytes, bytes]:
        return float(self.t[0]), self.x.tobytes(), self.m.tobytes(), self.d.tobytes()

    def evaluate(self) -> bool:
        """Derivatives into `xdot`, solutions of blocks into `z`; False where one of them is not finite.

        What Newton's method found is its next guess.
        """
        fine = self.ode()
        if self.guess.size:
            if not np.isfinite(self.z).all() and np.isfinite(self.x).all():
                fine = self._solved_otherwise()
            self._solved = self._point()
            if not np.isfinite(self.z).all():
                return False
            self.guess[:] = self.z
        return fine and bool(np.isfinite(self.xdot).all())

    def _solved_otherwise(self) -> bool:
        """From where blocks were settled, or by damped iterations: a refused step may mislead the guess."""
        misled = self.guess.copy()
        self.guess[:] = self.settled_z
        if self.ode() and np.isfinite(self.z).all():
            return True
        self.guess[:] = misled
        return self.walks.may_fail and self.walk_into([self.xdot, self.z], float(self.t[0]), self.x.copy())

    def settle(self) -> None:
        """Makes sure that the blocks are solved here, with the robust solver if need be.

        Raises `SimulationProblem` naming the block or equation that cannot be computed.
        """
        if not self.evaluate():
            values = self._explained()
            slots = self.code.dynamic.slots
            self.guess[:] = values[[slots[leaf] for leaf in self.code.dynamic.guesses]]
            if not self.evaluate():
                self.z[:] = self.guess
                self.xdot[:] = values[[slots[der(state)] for state in state_leaves(self.code.system)]]
        self.settled_z[:] = self.z

    def _explained(self) -> Vector:
        """From the guess, which a trial step may have left far away, else from where blocks were settled."""
        try:
            return self.explain()
        except SimulationProblem:
            if np.array_equal(self.guess, self.settled_z):
                raise
            self.guess[:] = self.settled_z
            return self.explain()

    def explain(self) -> Vector:
        """Walks the program at the present point: its values, or the error that names the culprit."""
        self.inputs.explain(float(self.t[0]), self.u)
        inputs = np.concatenate([self.t, self.x, self.p, self.m, self.u, self.d])
        how = Walk(SimulationProblem, float(self.t[0]), self.nominal_of(), self.guess_of())
        return walk(self.code.dynamic, inputs, how).values

    def walk_into(self, found: list[Vector], time: float, x: Vector) -> bool:
        """Derivatives and solutions of blocks by damped iterations, and now and then by homotopy.

        What a step found that was refused may mislead plain Newton iterations. False if these fail, too.
        """
        if not self.walks.begin(time):
            return False
        inputs = np.concatenate([[time], x, self.p, self.m, self.u, self.d])
        settled = dict(zip(map(leaf_name, self.code.dynamic.guesses), self.settled_z.tolist(), strict=True))
        slots, values = self.code.dynamic.slots, None
        attempts = [(self.guess_of(), True), (settled, True)]
        if self.walks.may_be_long:
            attempts.append((self.guess_of(), False))
        for guess, local in attempts:
            with suppress(SimulationProblem):
                how = Walk(SimulationProblem, time, self.nominal_of(), guess, local)
                walked = walk(self.code.dynamic, inputs, how)
                values = walked.values
                self._note_jumps(walked, time)
                break
        self.walks.end(found=values is not None)
        if values is None:
            return False
        found[0][:] = values[[slots[der(state)] for state in state_leaves(self.code.system)]]
        found[1][:] = values[[slots[leaf] for leaf in self.code.dynamic.guesses]]
        return True

    def _note_jumps(self, walked: Walked, time: float) -> None:
        """Of blocks of one unknown that were found beyond a fold."""
        program = self.code.dynamic
        slots, values = program.slots, walked.values
        for code in program.codes if walked.continued else ():
            if not isinstance(code, ImplicitCode) or len(code.block.tearing) != 1:
                continue
            z = code.block.tearing[0]
            before, after = float(self.guess[program.guesses.index(z)]), float(values[slots[z]])
            known = values[[slots[leaf] for leaf in code.reads]]
            if code.block in walked.continued and turns_between(code, known, before, after):
                self.jumps.note(code.block, time, before, after)

    def judge_jumps(self, time: float) -> None:
        """By where the run has got to, with the guesses that it left: whether blocks jumped on the way."""
        if self.jumps.are_pending:
            self.jumps.judge(time, dict(zip(self.code.dynamic.guesses, self.guess.tolist(), strict=True)))

    def nominal_of(self) -> dict[Expr, float]:
        return dict(zip(self.code.dynamic.guesses, self.z_nominal.tolist(), strict=True))

    def guess_of(self) -> dict[str, float]:
        return dict(zip(map(leaf_name, self.code.dynamic.guesses), self.guess.tolist(), strict=True))


def _positive(values: Vector) -> Vector:
    """Nominal values that can be divided by."""
    return np.where(np.isfinite(values) & (values > 0), values, 1.0)
