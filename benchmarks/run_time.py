"""What a run costs: the pressure regulator over one second, by CVODE here and by other integrators.

Timed: integration alone, from initial values to the stored result, at the same relative tolerance and output
grid. `ratio` is to acausal in the same run.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

import casadi as ca
import numpy as np
from scipy.integrate import solve_ivp

import acausal
from benchmarks.measure import Row, seconds

MODEL = "TenSpeed.Examples.MainRegulatorFlow"
RTOL = 1e-6
POINTS = 501


def rows() -> Iterator[Row]:
    """One row per integrator."""
    compiled = acausal.load(MODEL).compile()
    reference = compiled.simulate(rtol=RTOL)
    base = seconds(lambda: compiled.simulate(rtol=RTOL))
    yield {"integrator": "acausal, CVODE", "seconds": round(base, 4), "ratio": 1.0, "line_p": last(reference)}
    x0 = np.array([float(reference[name][0]) for name in compiled.states])
    parameters = np.array([reference.parameters[name] for name in compiled.causal.parameters])
    for label, work in others(compiled.code.ode, x0, parameters).items():
        taken = seconds(work)
        yield {
            "integrator": label,
            "seconds": round(taken, 4),
            "ratio": round(taken / base, 1),
            "line_p": float(np.asarray(work())[compiled.states.index("line.p")]),
        }


def last(result: object) -> float:
    """The line pressure at the end (Pa)."""
    assert isinstance(result, acausal.Result)
    return float(result["line.p"][-1])


def others(ode: ca.Function, x0: np.ndarray, p: np.ndarray) -> dict[str, Callable[[], object]]:
    """SciPy's BDF around the same function, and CasADi's own cvodes plugin."""
    t, x = ca.MX.sym("t"), ca.MX.sym("x", len(x0))
    inputs = [t, x, ca.DM(p)] + [ca.DM.zeros(*ode.size_in(i)) for i in range(3, ode.n_in())]
    derivative = ca.Function("f", [t, x], [ode(*inputs)[0] if ode.n_out() > 1 else ode(*inputs)])
    nominal = np.maximum(np.abs(x0), 1e-3)
    scaled = ca.MX.sym("z", len(x0))
    dae = {"t": t, "x": scaled, "ode": derivative(t, scaled * nominal) / nominal}
    grid = np.linspace(0, 1, POINTS)
    options = {"reltol": RTOL, "abstol": RTOL, "newton_scheme": "direct"}
    plugin = ca.integrator("F", "cvodes", dae, 0.0, grid[1:].tolist(), options)

    def scipy_bdf() -> object:
        run = solve_ivp(
            lambda t, y: np.asarray(derivative(t, y)).ravel(),
            (0, 1),
            x0,
            "BDF",
            rtol=RTOL,
            atol=RTOL * nominal,
            t_eval=grid,
        )
        return run.y[:, -1]

    def cvodes() -> object:
        return np.asarray(plugin(x0=x0 / nominal)["xf"])[:, -1] * nominal

    return {"SciPy BDF, CasADi derivative": scipy_bdf, "CasADi cvodes plugin": cvodes}
