"""Explicit steps of one length that are too long: which state sets the limit, and what the limit is.

A run that explodes is looked at where it began, half-way and near its end: the eigenvalues of the Jacobian
there give the longest stable step (`stability`), and the state with the largest share in the mode that sets
it, left times right eigenvector (Perez-Arriaga et al., IEEE Trans. PAS-101, 1982), is named.
"""

from __future__ import annotations

from collections.abc import Generator
from contextlib import contextmanager, suppress
from dataclasses import dataclass, replace

import numpy as np

from acausal.errors import AcausalError, Diagnostic
from acausal.simulate.evaluator import Evaluator
from acausal.simulate.failures import equation_of
from acausal.simulate.matrices import Vector
from acausal.simulate.messages import number
from acausal.simulate.options import Options
from acausal.simulate.record import Recorder
from acausal.simulate.stability import FLOOR, GROWTH, Complex, step_limit

_CODES = ("not-finite", "no-solution", "no-convergence", "singular")
"""How the codes of errors end that states without bound lead to."""
_MOST = 300
"""States up to which eigenvalues are computed."""
_SANE, _GROWN = 1e6, 1e9
"""Nominal or first values that states exceed no more than so many times where eigenvalues say something; what
has grown more is suspect."""


@dataclass(frozen=True)
class _Limit:
    """The longest stable step (s), the state that sets it, its eigenvalue, and where that is (s)."""

    step: float
    state: str
    eigenvalue: complex
    time: float


class ExplicitSteps:
    """Looks after one run; does nothing where its solver has other steps."""

    def __init__(self, evaluator: Evaluator, options: Options, x: Vector) -> None:
        self._evaluator = evaluator
        self._options = options
        self._is_explicit = options.solver in GROWTH and x.size > 0
        self._start = options.first, x.copy(), evaluator.m.copy(), evaluator.d.copy(), evaluator.guess.copy()
        self._sizes = np.maximum(np.abs(x), evaluator.x_nominal)

    @contextmanager
    def advising(self, recorder: Recorder) -> Generator[None, None, None]:
        """Adds to errors inside it, if they may be due to the length of steps, what that length may be."""
        try:
            yield
        except AcausalError as error:
            if not self._is_explicit or not error.codes[0].endswith(_CODES):
                raise
            first, *others = error.diagnostics
            advice = self._advice(recorder)
            hint = f"{first.hint}; {advice}" if first.hint else advice
            raise type(error)([replace(first, hint=hint), *others]) from error.__cause__

    def warnings(self, recorder: Recorder) -> tuple[Diagnostic, ...]:
        """Of a run that ended with numbers, but with such that its steps made."""
        if not self._is_explicit or not recorder.count:
            return ()
        end = self._states(recorder)[-1]
        if not (np.abs(end) > _GROWN * self._sizes).any():
            return ()
        limit = self._limit(recorder)
        if limit is None:
            return ()
        equation = equation_of(self._evaluator, limit.state)
        span = equation.flat.span if equation is not None else None
        message = f"the result is of no use: {_text(limit, self._options)}"
        hint = "try a shorter step or the solver lieuler or rosenbrock"
        return (Diagnostic("simulate.unstable", message, span, (limit.state,), hint, "warning"),)

    def _advice(self, recorder: Recorder) -> str:
        limit, options = self._limit(recorder), self._options
        other = "try a shorter step or the solver lieuler or rosenbrock; `acausal eigen` prints the limits"
        if limit is not None:
            return f"{_text(limit, options)}: {other}"
        return f"the step of {options.step:g} s may exceed the stability limit of {options.solver}: {other}"

    def _limit(self, recorder: Recorder) -> _Limit | None:
        """The shortest of the limits, if steps exceed it."""
        if self._sizes.size > _MOST:
            return None
        points = self._points(recorder)
        found = (min(self._at(*point), key=lambda limit: limit.step, default=None) for point in points)
        return next((limit for limit in found if limit and limit.step < self._options.step), None)

    def _points(self, recorder: Recorder) -> Generator[tuple[float, Vector], None, None]:
        """Where to look: the start with its modes, then as far as states are no larger than they may be."""
        e = self._evaluator
        present = e.m.copy(), e.d.copy(), e.guess.copy()
        time, x, *start = self._start
        for group, then in ((start, (time, x)), (present, None)):
            for array, values in zip((e.m, e.d, e.guess), group, strict=True):
                array[:] = values
            if then is not None:
                yield then
        rows, times = self._states(recorder), recorder.time
        with np.errstate(all="ignore"):
            sane = np.flatnonzero((np.abs(rows) <= _SANE * self._sizes).all(axis=1))
        if sane.size:
            yield from ((float(times[i]), rows[i]) for i in (sane[len(sane) // 2], sane[-1]))

    def _at(self, time: float, x: Vector) -> Generator[_Limit, None, None]:
        e = self._evaluator
        with suppress(AcausalError, np.linalg.LinAlgError):
            e.at(time, x)
            e.settle()
            e.jac()
            matrix = np.zeros((x.size, x.size))
            rows, columns = e.code.pattern.get_triplet()
            matrix[rows, columns] = e.jacobian
            found = np.linalg.eig(matrix)
            values: Complex = found.eigenvalues.astype(np.complex128)
            right: Complex = found.eigenvectors.astype(np.complex128)
            left = np.linalg.pinv(right)
            floor = FLOOR * float(np.abs(values).max(initial=0.0))
            damped = -1e-6 * np.abs(values)
            for i in np.flatnonzero((values.real < damped) & (np.abs(values) > floor)):
                step = float(step_limit(self._options.solver, [complex(values[i])]))
                state = int(np.argmax(np.abs(left[i, :] * right[:, i])))
                yield _Limit(step, e.code.system.states[state], complex(values[i]), time)

    def _states(self, recorder: Recorder) -> Vector:
        return recorder.columns(self._evaluator.code.system.states)


def _text(limit: _Limit, options: Options) -> str:
    value = limit.eigenvalue
    shown = number(value.real) if value.imag == 0 else f"{number(value.real)} +- {number(abs(value.imag))}i"
    return (
        f"the step of {options.step:g} s exceeds the stability limit of {options.solver}, "
        f"{number(limit.step)} s at time {limit.time:.6g} s, which the state {limit.state} sets "
        f"(eigenvalue {shown} 1/s)"
    )
