"""CasADi Functions that evaluate from and into arrays at fixed places."""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from functools import cached_property, partial
from typing import Any

import numpy as np
from casadi import Function

from acausal.codegen.c_text import time_rates
from acausal.codegen.functions import Code
from acausal.simulate.matrices import Vector


class Buffered:
    """One Function evaluating from `inputs` into `outputs`; False (and not-a-number) where CasADi fails.

    `before`, if given, runs first. Where a result is not finite, `rescue`, if given, has another try.
    """

    def __init__(
        self,
        function: Function,
        inputs: list[Vector],
        before: Callable[[], object] | None = None,
        rescue: Callable[[list[Vector]], bool] | None = None,
    ) -> None:
        self._function = function
        self._compiled: Callable[[], int] | None = None
        raw: Any = function.buffer()
        self._buffer: Any = raw[0]
        self._evaluate: Callable[[], None] = raw[1]
        self._before = before
        self._rescue = rescue
        self._inputs = inputs
        self.outputs = [np.zeros(function.nnz_out(i)) for i in range(function.n_out())]
        for i, array in enumerate(inputs):
            if array.size:
                self._buffer.set_arg(i, array.data)
        for i, array in enumerate(self.outputs):
            if array.size:
                self._buffer.set_res(i, array.data)

    def __call__(self) -> bool:
        if self._before is not None:
            self._before()
        if self._run() and (self._rescue is None or _all_finite(self.outputs)):
            return True
        if self._rescue is not None and self._rescue(self.outputs):
            return True
        for array in self.outputs:
            array.fill(np.nan)
        return False

    def _run(self) -> bool:
        if self._compiled is not None:
            return self._compiled() == 0
        try:
            self._evaluate()
            return self._buffer.ret() == 0
        except RuntimeError:
            return False

    def compile(self, library: ctypes.CDLL) -> None:
        """Evaluates by compiled C from now on, if the library has the Function."""
        function = self._function
        entry = getattr(library, function.name(), None)
        if entry is None:
            return
        tables = [np.zeros(size, dtype=np.uintp) for size in (function.sz_arg(), function.sz_res())]
        for table, arrays in zip(tables, (self._inputs, self.outputs), strict=True):
            table[: len(arrays)] = [array.ctypes.data for array in arrays]
        work = np.zeros(function.sz_iw() + 1, dtype=np.int64), np.zeros(function.sz_w() + 1)
        self._kept = (library, *tables, *work)
        entry.argtypes, entry.restype = [ctypes.c_void_p] * 4 + [ctypes.c_int], ctypes.c_int
        self._compiled = partial(entry, *(array.ctypes.data for array in (*tables, *work)), 0)


class Robust:
    """`Code.ode` and `Code.jac` over the same arrays, for where those of `Code.quick` give no numbers.

    The Functions are made when they are first needed.
    """

    def __init__(self, code: Code, inputs: list[Vector]) -> None:
        self._code = code
        self._inputs = inputs

    @cached_property
    def _ode(self) -> Buffered:
        return Buffered(self._code.ode, self._inputs)

    @cached_property
    def _jac(self) -> Buffered:
        return Buffered(self._code.fitting_jac, self._inputs)

    @cached_property
    def _rates(self) -> Buffered | None:
        rates = time_rates(self._code)
        return None if rates is None else Buffered(rates, self._inputs)

    def ode(self, outputs: list[Vector]) -> bool:
        """Derivatives and solutions of the blocks; False where there are none either."""
        if np.isfinite(outputs[1]).all():
            return False  # it is not the blocks
        fine = self._ode()
        return _taken(self._ode.outputs, outputs) and fine

    def slopes(self, outputs: list[Vector]) -> bool:
        """Slopes by states and time."""
        fine = self._jac()
        found = [self._jac.outputs[0], np.zeros(outputs[1].size)]
        if self._rates is not None and outputs[1].size:
            fine = self._rates() and fine
            found[1] = self._rates.outputs[0]
        return _taken(found, outputs) and fine


def _taken(found: list[Vector], into: list[Vector]) -> bool:
    """Copies the results; whether they are numbers."""
    for source, target in zip(found, into, strict=True):
        target[:] = source
    return _all_finite(into)


def _all_finite(arrays: list[Vector]) -> bool:
    return all(np.isfinite(array).all() for array in arrays)
