"""Independent reference for valves: explicit ODEs in NumPy, solved by SciPy.

Nothing here reads Modelica text: the equations are written from their physics, with the fluid and the laws
of flow of `reference_main_regulator`, and the values come in as dictionaries.

Linear solenoid valve, states i [A], s [m], v [m/s], p_fb [Pa], p_out [Pa]::

    R_nom i_cmd = R i + L di/dt + k_F v
    m dv/dt     = k_F i + F_0 - c s - d v - A_fb (p_fb - p_0) - supply jet + drain jet + stops
    dp_fb/dt    = K / (V_fb - A_fb s) (q_fb + A_fb v)
    dp_out/dt   = K / V_out (m_supply - m_drain - m_fb - m_load) / rho
"""

from __future__ import annotations

from typing import Any, cast

import numpy as np
from scipy.integrate import solve_ivp

from tests.models.reference_main_regulator import (
    DEFAULTS,
    Array,
    Parameters,
    bulk_modulus,
    density,
    restriction,
    smooth_step,
)

SOLENOID: dict[str, float] = {
    **DEFAULTS,
    "R_nom": 5.0,
    "R": 5.0,
    "L": 0.01,
    "k_F": 30.0,
    "m": 5e-3,
    "c": 15e3,
    "d": 15.0,
    "F_preload": 1.0,
    "s_max": 0.4e-3,
    "c_stop": 1e6,
    "b_stop": 1.0,
    "A_feedback": 32e-6,
    "V_feedback": 1e-6,
    "d_feedback": 1e-3,
    "d_edge": 8e-3,
    "coverage": 0.3,
    "s_supply": 0.055e-3,
    "s_drain": 0.07e-3,
    "V_out": 100e-6,
    "d_load": 0.6e-3,
    "p_supply": 10.5e5,
    "p_drain": 101325.0,
}
"""The defaults of `TenSpeed.Benches.LinearSolenoidL1`, in SI units."""


def sharp_edge(
    opening: float, p_a: float, p_b: float, diameter: float, par: Parameters
) -> tuple[float, float]:
    """Mass flow from a to b [kg/s] and closing force of the jet [N] of an edge without chamfer."""
    gap = 0.5 * (opening + np.sqrt(opening**2 + 4.0 * par["clearance"] ** 2))
    area = np.pi * diameter * par["coverage"] * gap
    flow = restriction(p_a, p_b, area, 2.0 * gap, par["C_d_edge"], par["Re_crit_edge"], par)
    rho = density(0.5 * (p_a + p_b), par)
    return flow, float(flow**2 * np.cos(par["jet_angle"]) / (rho * par["C_d_edge"] * area))


def orifice(p_a: float, p_b: float, diameter: float, par: Parameters) -> float:
    """Mass flow from a to b through a bore [kg/s]."""
    return restriction(p_a, p_b, 0.25 * np.pi * diameter**2, diameter, par["C_d"], par["Re_crit"], par)


def stops(s: float, v: float, par: Parameters) -> float:
    """Force of the elastic end stops at 0 and s_max [N]."""
    low = par["c_stop"] * max(0.0, -s) * max(0.0, 1.0 - par["b_stop"] * v)
    high = par["c_stop"] * max(0.0, s - par["s_max"]) * max(0.0, 1.0 + par["b_stop"] * v)
    return low - high


def solenoid(time: float, y: Array, par: Parameters, current: tuple[float, float, float]) -> Array:
    """Right-hand side of the linear solenoid valve; `current` is (start [s], duration [s], height [A])."""
    i, s, v, p_fb, p_out = map(float, y)
    i_cmd = current[2] * smooth_step((time - current[0]) / current[1])
    supplied, supply_jet = sharp_edge(s - par["s_supply"], par["p_supply"], p_out, par["d_edge"], par)
    drained, drain_jet = sharp_edge(par["s_drain"] - s, p_out, par["p_drain"], par["d_edge"], par)
    fed_back = orifice(p_out, p_fb, par["d_feedback"], par)
    load = orifice(p_out, par["p_drain"], par["d_load"], par)
    area = par["A_feedback"]
    force = (
        par["k_F"] * i
        + par["F_preload"]
        - par["c"] * s
        - par["d"] * v
        - area * (p_fb - par["p_ambient"])
        - supply_jet
        + drain_jet
        + stops(s, v, par)
    )
    return np.array(
        [
            (par["R_nom"] * i_cmd - par["R"] * i - par["k_F"] * v) / par["L"],
            v,
            force / par["m"],
            bulk_modulus(p_fb, par)
            / (par["V_feedback"] - area * s)
            * (fed_back / density(p_fb, par) + area * v),
            bulk_modulus(p_out, par)
            / par["V_out"]
            * (supplied - drained - fed_back - load)
            / density(p_out, par),
        ],
        dtype=np.float64,
    )


def solve_solenoid(
    par: Parameters, current: tuple[float, float, float], stop_time: float, points: int
) -> tuple[Array, Array]:
    """Time points and the states over them, from rest at ambient pressure."""
    start = np.array([0.0, par["F_preload"] / par["c"], 0.0, par["p_0"], par["p_0"]])
    result = cast(
        "Any",
        solve_ivp(
            solenoid,
            (0.0, stop_time),
            start,
            method="Radau",
            t_eval=np.linspace(0.0, stop_time, points),
            args=(par, current),
            rtol=1e-8,
            atol=1e-8 * np.array([1.0, 1e-3, 1.0, 1e5, 1e5]),
        ),
    )
    assert result.success, result.message
    return result.t, result.y
