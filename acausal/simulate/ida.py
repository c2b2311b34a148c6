"""IDA from SUNDIALS through scikit-sundae, for models left implicit: no Newton iteration inside another.

The unknowns are the states and the tearing variables of the implicit blocks, `F = (xdot - f(x, z), r(x, z))`,
with the exact sparse Jacobian. Everything else is as in `cvode`.
"""

from __future__ import annotations

import warnings

import numpy as np
from scipy.sparse import csc_matrix
from sksundae.ida import IDA

from acausal.codegen.implicit import implicit_form
from acausal.simulate.buffered import Buffered
from acausal.simulate.cvode import SPARSE_FROM, Cvode, Stepper
from acausal.simulate.evaluator import Evaluator
from acausal.simulate.matrices import Vector, is_finite
from acausal.simulate.solver import BATCH, Tolerances


class _Roots:
    """The zero-crossing callback; scikit-sundae keeps every event in lists on this object."""

    def __init__(self, evaluator: Evaluator) -> None:
        self.terminal = [True] * len(evaluator.located)
        self.direction = [0] * len(evaluator.located)
        self._evaluator = evaluator
        self._i: list[object] = []
        self._t: list[object] = []
        self._y: list[object] = []
        self._yp: list[object] = []

    def __call__(self, t: float, y: Vector, yp: Vector, events: Vector, /) -> None:
        del yp
        evaluator = self._evaluator
        evaluator.at(t, y[: evaluator.x.size])
        evaluator.crossings(events)

    def forget(self) -> None:
        """Empties those lists, which scikit-sundae would otherwise copy after every step."""
        for kept in (self._i, self._t, self._y, self._yp):
            kept.clear()


class Ida(Cvode):
    """The `Solver` over one IDA instance."""

    name = "IDA"

    def __init__(self, evaluator: Evaluator, tolerances: Tolerances) -> None:
        function = implicit_form(evaluator.code)
        self._z = np.zeros(evaluator.guess.size)
        given = {**evaluator.groups, "t": evaluator.t, "x": evaluator.x, "z": self._z}
        self._form = Buffered(function, [given[name] for name in function.name_in()])
        rows, columns = function.sparsity_out(1).get_triplet()
        self._prepare_pattern(evaluator.x.size, evaluator.guess.size, rows, columns)
        super().__init__(evaluator, tolerances)

    def _prepare_pattern(self, n: int, m: int, rows: list[int], columns: list[int]) -> None:
        """The pattern of d F / d y + c d F / d y': the form's, with a diagonal for the states."""
        size = max(1, n + m)
        given = np.asarray(columns, dtype=np.intp) * size + np.asarray(rows, dtype=np.intp)
        diagonal = np.arange(max(1, n) if not m else n) * (size + 1)
        numbers = np.unique(np.concatenate([given, diagonal]))
        self._full = numbers % size, numbers // size
        self._entries, self._diagonal = np.searchsorted(numbers, given), np.searchsorted(numbers, diagonal)
        self._signs = np.where(np.asarray(rows, dtype=np.intp) < n, -1.0, 1.0)
        self._total = size

    def _create(self) -> Stepper:
        limits, evaluator = self._tolerances, self._evaluator
        longest = limits.max_step or limits.sample
        sparse = self._total > SPARSE_FROM
        ones = np.ones(len(self._full[0]))
        n, atol = evaluator.x.size, np.ones(self._total)
        atol[:n] = limits.atol
        atol[n : n + evaluator.guess.size] = limits.rtol * evaluator.z_nominal
        roots = _Roots(evaluator) if evaluator.located.size else None
        self._roots = roots
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # the pattern is not used for differences: it is exact
            made = IDA(
                self._residual,
                algebraic_idx=list(range(n, self._total)) if evaluator.guess.size else None,
                jacfn=self._fill_sparse if sparse else self._fill_dense,
                linsolver="sparse" if sparse else "dense",
                sparsity=csc_matrix((ones, self._full), shape=(self._total, self._total)) if sparse else None,
                rtol=limits.rtol,
                atol=atol,
                min_step=limits.min_step,
                max_step=max(longest, limits.min_step) if longest else np.inf,
                max_num_steps=min(limits.max_steps, BATCH),
                eventsfn=roots,
                num_events=evaluator.located.size,
            )
        self._start_implicit = made.init_step
        return made

    def _evaluate(self, t: float, y: Vector) -> None:
        n = self._evaluator.x.size
        self._evaluator.at(t, y[:n])
        self._z[:] = y[n : n + self._z.size]
        self._form()

    def _residual(self, t: float, y: Vector, yp: Vector, residual: Vector, /) -> None:
        self._rhs_evaluations += 1
        if t > self._latest:
            self._steps += 1
        self._latest = t
        n = self._evaluator.x.size
        if not n and not self._z.size:
            residual[0] = yp[0]
            return
        self._evaluate(t, y)
        values = self._form.outputs[0]
        if not is_finite(values) and np.isfinite(y).all():
            self._broken = t, np.array(y[:n])
        with np.errstate(all="ignore"):
            residual[:n] = yp[:n] - values[:n]
        residual[n:] = values[n:]

    def _values(self, t: float, y: Vector, cj: float) -> Vector:
        self._count_jacobian()
        found = np.zeros(len(self._full[0]))
        if self._evaluator.x.size or self._z.size:
            self._evaluate(t, y)
            found[self._entries] = self._form.outputs[1] * self._signs
        found[self._diagonal] += cj
        return found

    def _fill_sparse(self, t: float, y: Vector, yp: Vector, r: Vector, cj: float, out: Vector, /) -> None:
        out[:] = self._values(t, y, cj)

    def _fill_dense(self, t: float, y: Vector, yp: Vector, r: Vector, cj: float, out: Vector, /) -> None:
        out[self._full] = self._values(t, y, cj)

    def _begin(self, time: float, x: Vector) -> None:
        evaluator = self._evaluator
        evaluator.at(time, x)
        evaluator.settle()
        y, yp = np.zeros(self._total), np.zeros(self._total)
        n = x.size
        y[:n], yp[:n] = x, evaluator.xdot
        y[n : n + self._z.size] = evaluator.z
        self._start_implicit(time, y, yp)

    def _take_guess(self, y: Vector) -> None:
        n = self._evaluator.x.size
        self._evaluator.guess[:] = y[n : n + self._z.size]
