"""`acausal_runtime.h` for `ctypes`: the structures field by field, and the functions with their types."""

from __future__ import annotations

import ctypes
from ctypes import POINTER, Structure, c_double, c_int, c_longlong, c_void_p

from acausal.runtime.build import run_time

REACHED, ROWS, EVENT, PAUSE, VIOLATED = range(5)
NOT_FINITE, STEP_TOO_SMALL, TOO_MANY_STEPS, SINGULAR, MEMORY, ROW_NOT_FINITE = range(-1, -7, -1)

METHODS = {
    name: number
    for number, name in enumerate(("rodas", "euler", "ab2", "heun", "rk3", "dopri5", "lieuler", "rosenbrock"))
}
"""The methods' numbers in the run-time; all but the first step with a fixed length."""

FILL = ctypes.CFUNCTYPE(None, c_void_p, c_double)
RESCUE = ctypes.CFUNCTYPE(c_int, c_void_p, c_int)

_DOUBLES, _INTS = c_void_p, c_void_p


def pointers(names: str) -> list[tuple[str, type[c_void_p]]]:
    """Fields that are pointers."""
    return [(name, c_void_p) for name in names.split()]


def typed(names: str, of: type[c_int | c_double | c_longlong]) -> list[tuple[str, type]]:
    """Fields of one type of numbers."""
    return [(name, of) for name in names.split()]


class FunctionStructure(Structure):
    """`ac_function`."""

    entry: int | None
    machine: int | None
    self: int | None
    arg: int
    res: int
    iw: int
    w: int
    _fields_ = [*pointers("entry machine self arg res iw w")]


class TableStructure(Structure):
    """`ac_table`."""

    position: int
    count: int
    times: int
    values: int
    _fields_ = [*typed("position count at", c_int), *pointers("times values")]


FUNCTIONS = ("ode", "jac", "derivative", "events", "scales", "output", "assertions", "timed", "timed_slopes")
"""Those of a model, in order."""


class ModelStructure(Structure):
    """`ac_model`."""

    states: int
    crossings: int
    guesses: int
    outputs: int
    conditions: int
    entries: int
    t: int
    x: int
    guess: int
    z: int
    xdot: int
    jacobian: int
    rate: int
    roots: int
    sizes: int
    row: int
    ok: int
    ode: FunctionStructure
    jac: FunctionStructure
    derivative: FunctionStructure
    events: FunctionStructure
    scales: FunctionStructure
    output: FunctionStructure
    assertions: FunctionStructure
    timed: FunctionStructure
    timed_slopes: FunctionStructure
    timed_at: float
    u: int
    tables: int
    table_count: int
    fill: int | None
    rescue: int | None
    autonomous: int
    exact_rate: int
    takes_solution: int
    free_roots: int
    evaluations: int
    jacobians: int
    _fields_ = [
        *typed("states crossings guesses outputs conditions entries", c_int),
        *pointers("t x guess z xdot jacobian rate roots sizes row ok"),
        *((n, FunctionStructure) for n in FUNCTIONS),
        *pointers("u tables"),
        *typed("table_count", c_int),
        *pointers("fill rescue owner"),
        *typed("autonomous exact_rate takes_solution unchecked free_roots settled", c_int),
        *typed("evaluations jacobians", c_longlong),
        *typed("timed_at", c_double),
    ]


class LuStructure(Structure):
    """`ac_lu`."""

    n: int
    capacity: int
    ap: int
    ai: int
    q: int
    searches: int
    repeats: int
    _fields_ = [
        *typed("n capacity", c_int),
        *pointers("ap ai q ax pinv lp li up ui lx ux ud work mark stack place reach"),
        *typed("factored", c_int),
        *typed("searches repeats", c_longlong),
    ]


class SolverStructure(Structure):
    """`ac_solver`."""

    model: int
    method: int
    locate: int
    rtol: float
    atol: int
    nominal: int
    min_step: float
    max_step: float
    step: float
    origin: float
    sample: float
    max_steps: int
    clock: int | None
    jmap: int
    diagonal: int
    t: float
    t0: float
    t1: float
    h: float
    x: int
    x0: int
    room: int
    crossed: int
    lu: LuStructure
    index: int
    steps: int
    rejected: int
    failures: int
    latest: float
    longest: float
    influence: int
    error_failures: int
    convergence_failures: int
    _fields_ = [
        *pointers("model"),
        *typed("method locate", c_int),
        *typed("rtol", c_double),
        *pointers("atol nominal"),
        *typed("min_step max_step step origin sample", c_double),
        *typed("max_steps", c_longlong),
        *pointers("clock jmap diagonal"),
        *typed("t t0 t1 h", c_double),
        *pointers("x x0 x1 f0 f1 f_old k1 k2 k3 z1 z0 stage k scale ratio error"),
        *pointers("side slack slack0 g_old g_new g_try g_mid crossed"),
        *typed(
            "have_step have_f0 have_old have_jacobian have_dense have_end first last_rejected "
            "pause longer room pending",
            c_int,
        ),
        *typed("h_next h_accepted err_accepted h_old", c_double),
        *typed("index", c_longlong),
        ("lu", LuStructure),
        *typed("steps rejected failures", c_longlong),
        *typed("latest longest read", c_double),
        *pointers("influence error_failures convergence_failures"),
    ]


class RunTime:
    """The run-time's functions; `library` compiles it when it is first needed on a machine."""

    def __init__(self) -> None:
        library = self.library = run_time()
        solver = POINTER(SolverStructure)
        self.doubles = library.ac_doubles
        self.doubles.argtypes, self.doubles.restype = [c_int] * 4, c_int
        self.init = library.ac_init
        self.init.argtypes, self.init.restype = [solver, _DOUBLES, _INTS], None
        self.lu_doubles, self.lu_ints = library.ac_lu_doubles, library.ac_lu_ints
        self.lu_doubles.argtypes, self.lu_ints.argtypes = [c_int] * 3, [c_int] * 2
        self.lu_init = library.ac_lu_init
        self.lu_init.argtypes, self.lu_init.restype = [POINTER(LuStructure), _DOUBLES, _INTS, c_int], None
        self.restart = library.ac_restart
        self.restart.argtypes, self.restart.restype = [solver, c_double, *[_DOUBLES] * 3], c_int
        self.sweep = library.ac_sweep
        self.sweep.argtypes = [solver, _DOUBLES, c_int, c_double, c_longlong, _DOUBLES, _INTS]
        self.sweep.restype = c_int
        self.clock = ctypes.cast(library.ac_clock, c_void_p).value
        self.sizes = library.ac_sizes
        self.sizes.argtypes, self.sizes.restype = [_INTS], None
