"""Does integrating cost what hand-written C costs? A stiff chain of 46 relief valves, 138 states, over 5 s.

CPU time of the integration alone, from initial values to the stored output grid of 500 points, at the same
relative tolerance 1e-6; `error` is the root mean square over all states and points, relative to their size,
against a run at 1e-10. The hand-written programs are `c/valve_chain_*.c`; CVODE and KLU come from the system
(Debian: libsundials-dev, libsuitesparse-dev). Heun's method takes 40,000 steps of 5 us over 0.2 s.
"""

from __future__ import annotations

import ctypes
import subprocess
import tempfile
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from statistics import median
from time import process_time

import casadi as ca
import numpy as np
from numpy.typing import NDArray
from scipy.integrate import solve_ivp
from scipy.sparse import csc_matrix

import acausal
from acausal.runtime.build import compiler
from acausal.simulate.machine import machine_of, pointer
from benchmarks.measure import Row
from benchmarks.valve_chain import VALVES, valve_chain

STOP, POINTS, RTOL = 5.0, 500, 1e-6
HEUN_STOP, HEUN_POINTS, HEUN_EACH = 0.2, 20, 2000
NAMES = [f"{kind}[{i}]" for i in range(1, VALVES + 1) for kind in "psv"]
NOMINAL = np.tile([1e5, 1e-3, 0.1], VALVES)
KLU = (
    "-lsundials_cvode",
    "-lsundials_nvecserial",
    "-lsundials_sunlinsolklu",
    "-lsundials_sunmatrixsparse",
    "-lklu",
)
FOLDER = Path(__file__).parent / "c"

Values = NDArray[np.float64]


@dataclass(frozen=True)
class Run:
    """CPU seconds, steps, and the states at the output points."""

    seconds: float
    steps: int
    values: Values | None


def rows(quick: bool = False) -> Iterator[Row]:
    """One row per integrator: variable steps first, Heun's method after."""
    repeats = 1 if quick else 5
    compiled = acausal.loads(valve_chain()).compile()
    exact = states(compiled.simulate(rtol=1e-10, compiled=True))
    found: dict[str, Run | str] = {"CVODE with KLU, by hand in C": by_hand("cvode", KLU, repeats)}
    for label, options in OURS.items():
        found[label] = ours(compiled, repeats if options.solver == "rodas" else 1, options)
    for label, work in others(compiled).items():
        found[label] = timed(work, 1 if "SciPy" in label else repeats)
    yield from _rows(found, exact)
    heun: dict[str, Run | str] = {"Heun, by hand in C": by_hand("heun", (), repeats)}
    heun["acausal, heun"] = ours(compiled, repeats, Ours("heun", True, HEUN_STOP, HEUN_POINTS))
    yield from _rows(heun, None)


@dataclass(frozen=True)
class Ours:
    """Settings of a run of acausal's."""

    solver: str
    compiled: bool | None = None
    stop: float = STOP
    points: int = POINTS


OURS = {
    "acausal, rodas, compiled": Ours("rodas", True),
    "acausal, rodas, virtual machine": Ours("rodas", False),
    "acausal, cvode (Python callbacks)": Ours("cvode"),
}


def _rows(found: dict[str, Run | str], exact: Values | None) -> Iterator[Row]:
    first = next(iter(found.values()))
    for label, run in found.items():
        if isinstance(run, str):
            yield {"integrator": label, "seconds": run, "ratio": "", "steps": "", "error": ""}
            continue
        ratio = round(run.seconds / first.seconds, 2) if isinstance(first, Run) else ""
        known = exact is not None and run.values is not None
        error = f"{difference(run.values, exact):.1e}" if known else ""
        yield {
            "integrator": label,
            "seconds": round(run.seconds, 4),
            "ratio": ratio,
            "steps": run.steps,
            "error": error,
        }


def difference(values: Values | None, exact: Values | None) -> float:
    """Root mean square, relative to the size of each value."""
    assert values is not None
    assert exact is not None
    return float(np.sqrt(np.mean(((values - exact) / (np.abs(exact) + NOMINAL)) ** 2)))


def states(result: acausal.Result) -> Values:
    """All states at the output points after the start."""
    return np.array([result.values(name)[1:] for name in NAMES]).T


def ours(model: acausal.CompiledModel, repeats: int, how: Ours) -> Run:
    """A run of acausal's, with what the command line reports as `cpu_seconds`."""
    runs = [
        model.simulate(
            stop_time=how.stop,
            interval=how.stop / how.points,
            rtol=RTOL,
            solver=how.solver,
            step=HEUN_STOP / HEUN_POINTS / HEUN_EACH,
            compiled=how.compiled,
        )
        for _ in range(repeats)
    ]
    seconds = median(run.statistics.cpu_seconds for run in runs)
    return Run(seconds, runs[-1].statistics.steps, states(runs[-1]))


def by_hand(name: str, libraries: tuple[str, ...], repeats: int) -> Run | str:
    """A hand-written program; a word where it cannot be built here."""
    tool = compiler()
    if tool is None:
        return "no C compiler"
    with tempfile.TemporaryDirectory() as folder:
        program = Path(folder) / name
        source = FOLDER / f"valve_chain_{name}.c"
        command = [
            tool.path,
            "-O2",
            "-std=c99",
            "-I/usr/include/suitesparse",
            str(source),
            "-o",
            str(program),
        ]
        built = subprocess.run([*command, *libraries, "-lm"], capture_output=True, check=False)
        if built.returncode != 0:
            return "no SUNDIALS with KLU here"
        fixed = [str(HEUN_STOP), str(HEUN_POINTS), str(repeats), str(HEUN_EACH)]
        words = fixed if name == "heun" else [str(STOP), str(POINTS), str(repeats), str(RTOL)]
        lines = subprocess.run(
            [program, *words], capture_output=True, text=True, check=True
        ).stdout.splitlines()
    times = [line.split() for line in lines[:repeats]]
    values = np.array([[float(v) for v in line.split()] for line in lines[repeats:]])
    return Run(median(float(t[0]) for t in times), int(times[0][1]), values)


def timed(work: Callable[[], Run], repeats: int) -> Run:
    """The median of CPU times of `work`."""
    runs: list[Run] = []
    for _ in range(repeats):
        began = process_time()
        run = work()
        runs.append(Run(process_time() - began, run.steps, run.values))
    return Run(median(run.seconds for run in runs), runs[-1].steps, runs[-1].values)


def others(compiled: acausal.CompiledModel) -> dict[str, Callable[[], Run]]:
    """CasADi's own cvodes plugin on the same function, and SciPy's BDF with compiled derivatives."""
    ode, count = compiled.code.ode, len(compiled.states)
    t, x = ca.MX.sym("t"), ca.MX.sym("x", count)
    p = compiled.simulate(stop_time=1e-6).parameters
    known = [t, x, ca.DM([p[name] for name in compiled.causal.parameters])]
    known += [ca.DM.zeros(*ode.size_in(i)) for i in range(3, ode.n_in())]
    derivative = ca.Function("f", [t, x], [ode(*known)[0]])
    order = [compiled.states.index(name) for name in NAMES]
    nominal = np.empty(count)
    nominal[order] = NOMINAL
    scaled = {"t": t, "x": x, "ode": derivative(t, x * nominal) / nominal}
    grid = np.linspace(0, STOP, POINTS + 1)
    options = {"reltol": RTOL, "abstol": RTOL, "newton_scheme": "direct", "linear_solver": "qr"}
    plugin = ca.integrator("F", "cvodes", scaled, 0.0, grid[1:].tolist(), options)

    def cvodes() -> Run:
        values = np.asarray(plugin(x0=0)["xf"]).T * nominal
        return Run(0.0, int(plugin.stats().get("nsteps", 0)), values[:, order])

    def scipy_bdf() -> Run:
        call = _compiled_slope(compiled)
        pattern = ode.jac_sparsity(0, 1)
        rows, columns = pattern.get_triplet()
        sparsity = csc_matrix((np.ones(len(rows)), (rows, columns)), shape=(count, count))
        run = solve_ivp(
            call, (0, STOP), np.zeros(count), "BDF", rtol=RTOL, atol=RTOL * nominal, t_eval=grid[1:],
            jac_sparsity=sparsity,
        )  # fmt: skip
        return Run(0.0, int(run.nfev), run.y.T[:, order])

    return {"CasADi's cvodes plugin, qr": cvodes, "SciPy BDF, compiled derivatives": scipy_bdf}


def _compiled_slope(compiled: acausal.CompiledModel) -> Callable[[float, Values], Values]:
    """The derivatives as compiled C, called from Python."""
    machine = machine_of(compiled.code)
    machine.compile()
    library = machine.library
    assert library is not None
    function = compiled.code.ode
    p = compiled.simulate(stop_time=1e-6).parameters
    inputs = [np.zeros(max(1, function.nnz_in(i))) for i in range(function.n_in())]
    inputs[2][:] = [p[name] for name in compiled.causal.parameters]
    out, z = np.zeros(len(compiled.states)), np.zeros(1)
    arg = np.array([pointer(array) for array in inputs] + [0] * function.sz_arg(), dtype=np.uintp)
    res = np.array([pointer(out), pointer(z)] + [0] * function.sz_res(), dtype=np.uintp)
    iw, w = np.zeros(function.sz_iw() + 1, dtype=np.int64), np.zeros(function.sz_w() + 1)
    entry = library.ode
    entry.argtypes = [ctypes.c_void_p] * 4 + [ctypes.c_int]
    kept = (arg, res, iw, w)

    def call(time: float, x: Values) -> Values:
        inputs[0][0], inputs[1][:] = time, x
        entry(*[pointer(array) for array in kept], 0)
        return out.copy()

    return call
