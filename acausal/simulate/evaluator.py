"""The compiled Functions bound to arrays: no allocation, no CasADi matrices, under a microsecond per call.

`casadi.Function.buffer` evaluates on memory that is handed over once; all Functions share the same inputs, so a
callback copies time and states in, evaluates, and copies the result out.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from casadi import Function

from acausal.codegen.functions import Code
from acausal.errors import SimulationProblem
from acausal.simulate.messages import leaf_name
from acausal.simulate.newton import Vector
from acausal.simulate.walk import Walk, call, walk
from acausal.symbolic.expressions.expr import Expr


class Buffered:
    """One Function evaluating from `inputs` into `outputs`; False (and not-a-number) where CasADi fails."""

    def __init__(self, function: Function, inputs: list[Vector]) -> None:
        raw: Any = function.buffer()
        self._buffer: Any = raw[0]
        self._evaluate: Callable[[], None] = raw[1]
        self.outputs = [np.zeros(function.nnz_out(i)) for i in range(function.n_out())]
        for i, array in enumerate(inputs):
            if array.size:
                self._buffer.set_arg(i, memoryview(array))
        for i, array in enumerate(self.outputs):
            if array.size:
                self._buffer.set_res(i, memoryview(array))

    def __call__(self) -> bool:
        try:
            self._evaluate()
            if self._buffer.ret() == 0:
                return True
        except RuntimeError:
            pass
        for array in self.outputs:
            array.fill(np.nan)
        return False


class Evaluator:
    """Numbers of one run: parameters, modes and guesses, which the Functions read in place."""

    def __init__(self, code: Code, parameters: Vector) -> None:
        self.code = code
        self.t = np.zeros(1)
        self.x = np.zeros(len(code.system.states))
        self.p = parameters.copy()
        self.m = np.zeros(len(code.system.zero_crossings))
        self.guess = np.zeros(len(code.dynamic.guesses))
        nominal = call(code.nominals, self.p)
        self.x_nominal = _positive(nominal[0].ravel())
        self.z_nominal = _positive(nominal[1].ravel())
        shared = [self.t, self.x, self.p, self.m, self.guess]
        self.ode = Buffered(code.ode, shared)
        self.jac = Buffered(code.jac, shared)
        self.output = Buffered(code.outputs, shared)
        self.event = Buffered(code.events, shared)
        self.size = Buffered(code.sizes, shared)
        self.condition = Buffered(code.conditions, shared)
        self.xdot, self._guess_out = self.ode.outputs
        self.roots = self.event.outputs[0]
        self.sizes = self.size.outputs[0]
        self.jacobian = self.jac.outputs[0]

    def at(self, time: float, x: Vector) -> None:
        """Sets the point at which the Functions evaluate."""
        self.t[0] = time
        self.x[:] = x

    def evaluate(self) -> bool:
        """Derivatives into `xdot`; solved guesses become the next guesses. False where something is not finite."""
        fine = self.ode()
        if self.guess.size and np.isfinite(self._guess_out).all():
            self.guess[:] = self._guess_out
        return fine and bool(np.isfinite(self.xdot).all())

    def settle(self) -> None:
        """Makes sure that the blocks are solved here, with the robust solver if need be.

        Raises `SimulationProblem` naming the block or equation that cannot be computed.
        """
        if self.evaluate():
            if not self.guess.size or np.isfinite(self._guess_out).all():
                return
        values = self.explain()
        for i, leaf in enumerate(self.code.dynamic.guesses):
            self.guess[i] = values[self.code.dynamic.slots[leaf]]
        self.evaluate()

    def explain(self) -> Vector:
        """Walks the program at the present point: its values, or the error that names the culprit."""
        program = self.code.dynamic
        inputs = np.concatenate([self.t, self.x, self.p, self.m])
        how = Walk(SimulationProblem, float(self.t[0]), self.nominal_of(), self.guess_of())
        return walk(program, inputs, how)

    def nominal_of(self) -> dict[Expr, float]:
        return dict(zip(self.code.dynamic.guesses, self.z_nominal.tolist(), strict=True))

    def guess_of(self) -> dict[str, float]:
        return dict(zip(map(leaf_name, self.code.dynamic.guesses), self.guess.tolist(), strict=True))


def _positive(values: Vector) -> Vector:
    """Nominal values that can be divided by."""
    return np.where(np.isfinite(values) & (values > 0), values, 1.0)
