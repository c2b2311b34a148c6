"""Independent reference for the main-regulator circuit: explicit ODE in NumPy, solved by SciPy.

Nothing here reads Modelica text. The equations are written again from their physics, and the values
come in as a dictionary, so that agreement with the compiled `TenSpeed.Examples.MainRegulatorFlow`
and `...Pressure` says something about the compiler.

Circuit::

    flow or pressure source --- line volume --+-- edge converter ---> p_converter (prescribed)
                                              +-- edge lubrication -> p_lubrication (prescribed)
                                              +-- edge suction -----> p_suction (prescribed)
                                              +-- feedback orifice -- feedback chamber (opens the spool)
    pilot supply (prescribed) --- pilot orifice -- pilot chamber (closes the spool, with the spring)

States, in this order: spool position s [m], spool speed v [m/s], feedback chamber pressure [Pa],
pilot chamber pressure [Pa] and, with the flow source only, line pressure [Pa].

Fluid (all pressures absolute)::

    specific volume over its reference  w = (1 - a) exp(-(p - p0) / K_l) + a exp(-(p_g - p0) / p_d) p0 / p_g
    gas pressure, positive for every p  p_g = (p + sqrt(p^2 + p_m^2)) / 2 + 1e-6 p_m
    density, bulk modulus               rho = rho_0 / w,  K = -w / w'

Restriction (C_d discharge coefficient, A area, d_h hydraulic diameter)::

    dp_crit = rho / 2 (Re_crit nu / (C_d d_h))^2
    m_flow  = C_d A sqrt(2 rho) dp / (dp^2 + dp_crit^2)^(1/4),   rho at the mean of both pressures

Volume: d(rho V)/dt = rho sum(q), hence dp/dt = K / V (sum(q) - dV/dt), with q = m_flow / rho at the pressure
of the volume.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, cast

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

Array = NDArray[np.float64]
Parameters = Mapping[str, float]

EDGES = ("converter", "lubrication", "suction")

#: The defaults of `TenSpeed.Interfaces.MainRegulatorCircuit` and the two examples, in SI units.
DEFAULTS: dict[str, float] = {
    # fluid
    "p_ref": 101325.0,
    "rho_ref": 830.0,
    "nu": 29.6e-6,
    "K_liquid": 1.5e9,
    "air_fraction": 0.01,
    "p_dissolve": 2.0e6,
    "p_gas_min": 1.0e3,
    # line
    "V_line": 500e-6,
    # spool
    "m": 1e-3,
    "c": 6000.0,
    "F_preload": 23.5,
    "damping_ratio": 0.05,
    "s_min": 0.0,
    "s_max": 5e-3,
    "c_stop": 1e6,
    "b_stop": 1.0,
    # edges
    "d_spool": 14e-3,
    "coverage": 0.25,
    "clearance": 10e-6,
    "chamfer": 0.3e-3,
    "chamfer_angle": float(np.deg2rad(30.0)),
    "jet_angle": float(np.deg2rad(69.0)),
    "C_d_edge": 0.7,
    "Re_crit_edge": 100.0,
    "overlap_converter": 0.5e-3,
    "overlap_lubrication": 0.9e-3,
    "overlap_suction": 1.3e-3,
    # chambers and their orifices
    "A_feedback": 50e-6,
    "A_pilot": 50e-6,
    "V_feedback": 2e-6,
    "V_pilot": 2e-6,
    "d_feedback": 1.2e-3,
    "d_pilot": 1.5e-3,
    "C_d": 0.7,
    "Re_crit": 100.0,
    # surroundings
    "p_ambient": 101325.0,
    "p_pilot_supply": 3e5,
    "p_converter": 4e5,
    "p_lubrication": 2e5,
    "p_suction": 101325.0,
    # flow source: smooth ramp from q_start to q_end
    "q_start": 0.0,
    "q_end": 20e-3 / 60.0,
    "q_ramp_start": 0.0,
    "q_ramp_duration": 0.2,
    # pressure source: smooth ramp from p_start to p_end
    "p_start": 10e5,
    "p_end": 10e5,
    "p_ramp_start": 0.0,
    "p_ramp_duration": 1.0,
    # start values of the states
    "s_0": 0.0,
    "v_0": 0.0,
    "p_0": 101325.0,
}


@dataclass(frozen=True)
class Reference:
    """A solution: `time` [s] and one row of `states` per state in `names`."""

    time: Array
    names: tuple[str, ...]
    states: Array
    parameters: Parameters

    def at_end(self) -> dict[str, float]:
        """The states at the last point, by name."""
        return dict(zip(self.names, map(float, self.states[:, -1]), strict=True))


def smooth_step(u: float) -> float:
    """Quintic from 0 (u <= 0) to 1 (u >= 1), twice continuously differentiable."""
    u = min(1.0, max(0.0, u))
    return u**3 * (10.0 + u * (-15.0 + 6.0 * u))


def specific_volume(pressure: float, par: Parameters) -> tuple[float, float]:
    """Specific volume over its reference value, and its derivative by pressure [1/Pa]."""
    over = pressure - par["p_ref"]
    air = par["air_fraction"]
    root_ = np.hypot(pressure, par["p_gas_min"])
    liquid = (1.0 - air) * np.exp(-over / par["K_liquid"])
    p_gas = 0.5 * (pressure + root_) + 1e-6 * par["p_gas_min"]
    gas = air * np.exp(-(p_gas - par["p_ref"]) / par["p_dissolve"]) * par["p_ref"] / p_gas
    slope = -liquid / par["K_liquid"] - gas * (1.0 / par["p_dissolve"] + 1.0 / p_gas) * 0.5 * (
        1.0 + pressure / root_
    )
    return float(liquid + gas), float(slope)


def density(pressure: float, par: Parameters) -> float:
    """Density of the oil with its air [kg/m3]."""
    return par["rho_ref"] / specific_volume(pressure, par)[0]


def bulk_modulus(pressure: float, par: Parameters) -> float:
    """Effective bulk modulus rho dp/drho [Pa]."""
    volume, slope = specific_volume(pressure, par)
    return -volume / slope


def restriction(
    p_a: float, p_b: float, area: float, d_h: float, c_d: float, re_crit: float, par: Parameters
) -> float:
    """Mass flow from a to b [kg/s]."""
    rho = density(0.5 * (p_a + p_b), par)
    dp = p_a - p_b
    dp_crit = 0.5 * rho * (re_crit * par["nu"] / (c_d * d_h)) ** 2
    return float(c_d * area * np.sqrt(2.0 * rho) * dp / (dp**2 + dp_crit**2) ** 0.25)


def edge_opening(displacement: float, par: Parameters) -> float:
    """Metering gap of a chamfered edge [m]; `displacement` is the position minus the overlap."""

    def positive(x: float) -> float:
        return float(0.5 * (x + np.sqrt(x**2 + 4.0 * par["clearance"] ** 2)))

    slope = np.sin(par["chamfer_angle"])
    return float(slope * positive(displacement) + (1.0 - slope) * positive(displacement - par["chamfer"]))


def edge(s: float, p_line: float, name: str, par: Parameters) -> tuple[float, float]:
    """Mass flow out of the line [kg/s] and closing flow force [N] of one metering edge."""
    gap = edge_opening(s - par[f"overlap_{name}"], par)
    area = np.pi * par["d_spool"] * par["coverage"] * gap
    p_out = par[f"p_{name}"]
    flow = restriction(p_line, p_out, area, 2.0 * gap, par["C_d_edge"], par["Re_crit_edge"], par)
    rho = density(0.5 * (p_line + p_out), par)
    return flow, float(flow**2 * np.cos(par["jet_angle"]) / (rho * par["C_d_edge"] * area))


def stop_force(s: float, v: float, par: Parameters) -> float:
    """Force of both elastic end stops on the spool [N]: c delta (1 + b ddelta/dt), never pulling."""
    low = max(0.0, par["s_min"] - s)
    high = max(0.0, s - par["s_max"])
    push_up = par["c_stop"] * low * max(0.0, 1.0 - par["b_stop"] * v)
    push_down = par["c_stop"] * high * max(0.0, 1.0 + par["b_stop"] * v)
    return push_up - push_down


def line_pressure_source(time: float, par: Parameters) -> float:
    """Prescribed line pressure [Pa]."""
    u = (time - par["p_ramp_start"]) / par["p_ramp_duration"]
    return par["p_start"] + (par["p_end"] - par["p_start"]) * smooth_step(u)


def flow_source(time: float, par: Parameters) -> float:
    """Prescribed volume flow into the line at the line's density [m3/s]."""
    u = (time - par["q_ramp_start"]) / par["q_ramp_duration"]
    return par["q_start"] + (par["q_end"] - par["q_start"]) * smooth_step(u)


def derivative(time: float, y: Array, par: Parameters, supply: str) -> Array:
    """Right-hand side; `supply` is "flow" (5 states) or "pressure" (4 states)."""
    s, v, p_fb, p_pilot = map(float, y[:4])
    p_line = float(y[4]) if supply == "flow" else line_pressure_source(time, par)

    edges = [edge(s, p_line, name, par) for name in EDGES]
    area = {name: 0.25 * np.pi * par[f"d_{name}"] ** 2 for name in ("feedback", "pilot")}
    m_fb = restriction(p_line, p_fb, area["feedback"], par["d_feedback"], par["C_d"], par["Re_crit"], par)
    m_pilot = restriction(
        par["p_pilot_supply"], p_pilot, area["pilot"], par["d_pilot"], par["C_d"], par["Re_crit"], par
    )

    damping = 2.0 * par["damping_ratio"] * np.sqrt(par["c"] * par["m"])
    force = (
        par["A_feedback"] * (p_fb - par["p_ambient"])
        - par["A_pilot"] * (p_pilot - par["p_ambient"])
        - par["F_preload"]
        - par["c"] * s
        - damping * v
        + stop_force(s, v, par)
        - sum(f for _, f in edges)
    )
    volume_fb = par["V_feedback"] + par["A_feedback"] * s
    volume_pilot = par["V_pilot"] - par["A_pilot"] * s
    rate_fb = bulk_modulus(p_fb, par) / volume_fb * (m_fb / density(p_fb, par) - par["A_feedback"] * v)
    rate_pilot = (
        bulk_modulus(p_pilot, par) / volume_pilot * (m_pilot / density(p_pilot, par) + par["A_pilot"] * v)
    )
    rates = [v, force / par["m"], rate_fb, rate_pilot]
    if supply == "flow":
        out = (m_fb + sum(m for m, _ in edges)) / density(p_line, par)
        rates.append(bulk_modulus(p_line, par) / par["V_line"] * (flow_source(time, par) - out))
    return np.array(rates, dtype=np.float64)


def state_names(supply: str) -> tuple[str, ...]:
    """Names of the states, in the order of `derivative`."""
    common = ("s", "v", "p_feedback", "p_pilot")
    return (*common, "p_line") if supply == "flow" else common


def start(par: Parameters, supply: str) -> Array:
    """The start values as a state vector."""
    count = 3 if supply == "flow" else 2
    return np.array([par["s_0"], par["v_0"], *([par["p_0"]] * count)], dtype=np.float64)


_SCALE = np.array([1e-3, 1.0, 1e5, 1e5, 1e5])


def solve(
    par: Parameters, supply: str, stop_time: float = 1.0, points: int = 501, rtol: float = 1e-8
) -> Reference:
    """Integrate from the start values with Radau, at most 10 ms per step."""
    result = cast(
        "Any",
        solve_ivp(
            derivative,
            (0.0, stop_time),
            start(par, supply),
            method="Radau",
            t_eval=np.linspace(0.0, stop_time, points),
            args=(par, supply),
            rtol=rtol,
            atol=2e-8 * _SCALE[: len(state_names(supply))],
            max_step=0.01,
        ),
    )
    if not result.success:
        raise RuntimeError(result.message)
    return Reference(result.t, state_names(supply), result.y, par)


def jacobian(par: Parameters, supply: str, state: Array, time: float = 1e6) -> Array:
    """Derivative of the right-hand side by the states, by central differences."""
    columns: list[Array] = []
    for index, size in enumerate(_SCALE[: state.size]):
        step = np.zeros(state.size)
        step[index] = 1e-6 * size
        upper = derivative(time, state + step, par, supply)
        lower = derivative(time, state - step, par, supply)
        columns.append((upper - lower) / (2.0 * step[index]))
    return np.column_stack(columns)


def steady_state(par: Parameters, supply: str, guess: Array, time: float = 1e6) -> Array:
    """The equilibrium next to `guess` by Newton's method; by default every ramp has finished."""
    state = guess.copy()
    for _ in range(50):
        change = np.linalg.solve(jacobian(par, supply, state, time), derivative(time, state, par, supply))
        state = state - change
        if np.all(np.abs(change) < 1e-11 * _SCALE[: state.size]):
            return state
    raise RuntimeError(f"no equilibrium found next to {guess}")


def eigenvalues(par: Parameters, supply: str, state: Array, time: float = 1e6) -> NDArray[np.complex128]:
    """Eigenvalues [1/s] of the system linearised at `state`."""
    return np.asarray(np.linalg.eigvals(jacobian(par, supply, state, time)), dtype=np.complex128)


def settling_time(found: Reference, end: Array) -> float:
    """Last time [s] at which any state is further than 1 % of its scale or end value from `end`."""
    band = 0.01 * np.maximum(np.abs(end), _SCALE[: end.size])
    outside = np.nonzero(np.any(np.abs(found.states - end[:, None]) > band[:, None], axis=0))[0]
    return float(found.time[outside[-1]]) if outside.size else 0.0


def report(name: str, par: Parameters, supply: str) -> None:
    """Print end values, equilibrium, settling time, eigenvalues and what each edge passes."""
    found = solve(par, supply)
    end = steady_state(par, supply, found.states[:, -1])
    p_line = float(end[4]) if supply == "flow" else par["p_end"]
    print(name)
    for index, state in enumerate(found.names):
        row = found.states[index]
        print(f"  {state:11s} end {row[-1]:.9g}  equilibrium {end[index]:.9g}  largest {row.max():.6g}")
    print(f"  settled within 1 % after {settling_time(found, end):.3f} s")
    print("  eigenvalues", np.sort_complex(eigenvalues(par, supply, end)))
    for outlet in EDGES:
        flow, force = edge(float(end[0]), p_line, outlet, par)
        print(f"  {outlet:11s} {6e4 * flow / density(p_line, par):8.4f} l/min  flow force {force:.4f} N")


def main() -> None:
    """Print the figures a person checks the parameters with."""
    ramp = {"p_start": 6e5, "p_end": 10.5e5, "p_ramp_start": 0.2, "p_ramp_duration": 0.3}
    report("MainRegulatorFlow", DEFAULTS, "flow")
    report("MainRegulatorPressure", DEFAULTS, "pressure")
    report("MainRegulatorPressureRamp", {**DEFAULTS, **ramp}, "pressure")


if __name__ == "__main__":
    main()
