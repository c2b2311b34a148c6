"""A model's functions for the run-time: bound to arrays, by CasADi's virtual machine or as compiled C.

Both do the same operations in the same order with the same library, so that their results are the same to
the bit, as far as the C compiler does not compute ahead what the library rounds otherwise. Compiling costs a
second or more, a virtual machine about three times the time per evaluation. `Machine` therefore takes the
compiled functions where they are in the cache already. Else it begins on the virtual machine, has the
functions compiled by another process once a run has made `WORTH` evaluations, and takes them when they are
there: in this run if it is long, else in the next. Where a run's fewest possible steps cost more on the
virtual machine than compiling does, it waits for the compiler.
"""

from __future__ import annotations

import ctypes
from collections.abc import Sequence
from contextlib import suppress
from functools import cache
from pathlib import Path
from typing import Any
from weakref import finalize

import casadi as ca
import numpy as np
from casadi import Function
from numpy.typing import NDArray

from acausal.codegen.c_text import c_text, event_functions, run_functions
from acausal.codegen.functions import Code
from acausal.codegen.kernels import is_evaluated_in_python
from acausal.codegen.staged import STAGES, staged
from acausal.errors import UnsupportedProblem
from acausal.runtime import build
from acausal.runtime.binding import FunctionStructure
from acausal.simulate.call import call
from acausal.simulate.matrices import Vector

WORTH = 4_000
"""Evaluations that make a model worth compiling in the background."""
LARGE = 40_000
"""Lines of C of one function from which on the compiler is told to try less hard, as for those without loops:
of the derivatives of 46 valves it makes code of the same speed with `-O1` as with `-O3`, in half the time."""
HOPELESS = 150_000
"""Lines of C of all functions from which on nothing is compiled unasked."""
_PER_LINE = 1.5e-4
_PER_OPERATION = 2.7e-9
"""Seconds that compiling a line, and an operation on the virtual machine, take: measured on the gearbox."""

_Kept = list[object]


class Machine:
    """The functions of one `Code`, and its compiled library if there is one."""

    def __init__(self, code: Code) -> None:
        self.staged = staged(run_functions(code))
        self.functions = self.staged.functions
        """What an integrator calls, by the run-time's names."""
        everything = {**self.functions, **event_functions(code)}
        self._all = {name: f for name, f in everything.items() if not is_evaluated_in_python(f)}
        self._sources: build.Sources | None = None
        self._begun = False
        self.library: ctypes.CDLL | None = None

    def stages(self, p: Vector) -> dict[str, Vector]:
        """What functions share, by name: what depends on parameters alone, and room for what time changes."""
        held, functions = self.staged.held, self.functions
        if held is None:
            return {}
        room = {name: np.zeros(functions[name].nnz_out(0) if name in functions else 0) for name in STAGES}
        return {**room, "held": call(held, p)[0].ravel()}

    @property
    def sources(self) -> build.Sources:
        """The C text, made when it is first asked for: a file for each function."""
        if self._sources is None:
            texts = {f"{name}.c": c_text({name: function}) for name, function in self._all.items()}
            light = [f"{name}.c" for name, f in self._all.items() if f.is_a("SXFunction")]
            light += [name for name in texts if name not in light and texts[name].count("\n") > LARGE]
            self._sources = build.Sources(texts, light=tuple(light))
        return self._sources

    @property
    def lines(self) -> int:
        """Lines of C."""
        return sum(text.count("\n") for text in self.sources.files.values())

    def pays(self, steps: float, evaluations: float) -> bool:
        """Whether so many steps with so many evaluations each cost more than to compile first."""
        if not steps or not evaluations or self.lines > HOPELESS or not build.may_compile():
            return False
        per_step = evaluations * self._operations("ode") + self._operations("jac")
        return steps * per_step * _PER_OPERATION > self.lines * _PER_LINE

    def _operations(self, name: str) -> int:
        text = self.sources.files.get(f"{name}.c", "")
        return text.count(";\n")

    def take(self, compiled: bool | None, steps: float, evaluations: float) -> None:
        """Takes compiled functions if wanted, or if so many steps with so many evaluations make it pay."""
        if compiled is None:
            self.look_up()
            if self.library is None and self.pays(steps, evaluations):
                with suppress(UnsupportedProblem):  # the virtual machine does it too
                    self.compile()
        elif compiled:
            self.compile()

    def look_up(self) -> None:
        """Takes the compiled functions if they are in the cache."""
        if self.library is None:
            self._load(build.cached(self.sources))

    def begin(self) -> None:
        """Has the functions compiled by another process; `look_up` finds them when it is done."""
        if not self._begun:
            self._begun = True
            if self.lines <= HOPELESS:
                build.start(self.sources)

    def compile(self) -> None:
        """Compiles if that has not happened. Raises `UnsupportedProblem` where it cannot."""
        if self.library is None:
            self._load(build.build(self.sources))

    def _load(self, path: Path | None) -> None:
        if path is not None:
            self.library = build.load(path)


_machines: dict[int, Machine] = {}


def machine_of(code: Code) -> Machine:
    """The machine of a compiled system, shared by its runs while it lives."""
    key = id(code)
    if key not in _machines:
        _machines[key] = Machine(code)
        finalize(code, _machines.pop, key, None)
    return _machines[key]


def pointer(array: NDArray[Any]) -> int:
    """Where the array's numbers are."""
    return int(array.ctypes.data)


def bound(
    function: Function, inputs: Sequence[Vector], outputs: Sequence[Vector], library: ctypes.CDLL | None
) -> tuple[FunctionStructure, _Kept]:
    """The function from and into these arrays, and what has to live as long as the structure does."""
    structure = FunctionStructure()
    if library is None or is_evaluated_in_python(function):
        return structure, _bind_machine(structure, function, inputs, outputs)
    arg = np.zeros(function.sz_arg(), dtype=np.uintp)
    res = np.zeros(function.sz_res(), dtype=np.uintp)
    arg[: len(inputs)] = [pointer(array) for array in inputs]
    res[: len(outputs)] = [pointer(array) for array in outputs]
    iw = np.zeros(function.sz_iw() + 1, dtype=np.int64)
    w = np.zeros(function.sz_w() + 1)
    structure.entry = ctypes.cast(getattr(library, function.name()), ctypes.c_void_p).value
    structure.arg, structure.res = pointer(arg), pointer(res)
    structure.iw, structure.w = pointer(iw), pointer(w)
    return structure, [arg, res, iw, w, *inputs, *outputs, library]


def _bind_machine(
    structure: FunctionStructure, function: Function, inputs: Sequence[Vector], outputs: Sequence[Vector]
) -> _Kept:
    raw: Any = function.buffer()
    buffer: Any = raw[0]
    for i, array in enumerate(inputs):
        if array.size:
            buffer.set_arg(i, array.data)
    for i, array in enumerate(outputs):
        if array.size:
            buffer.set_res(i, array.data)
    structure.machine = _evaluator()
    structure.self = _address(buffer._self())
    return [raw, function, *inputs, *outputs]


def _address(capsule: object) -> int | None:
    """What a Python capsule points to."""
    unpack = ctypes.pythonapi.PyCapsule_GetPointer
    unpack.restype, unpack.argtypes = ctypes.c_void_p, [ctypes.py_object, ctypes.c_char_p]
    return unpack(capsule, None)


@cache
def _evaluator() -> int | None:
    """CasADi's function that evaluates a buffer, without Python in between."""
    folder = Path(ca.__file__).parent
    for path in sorted(folder.glob("libcasadi.*")):
        library = ctypes.CDLL(str(path))
        try:
            return ctypes.cast(library["_ZN6casadi21_function_buffer_evalEPv"], ctypes.c_void_p).value
        except AttributeError:
            continue
    return None
