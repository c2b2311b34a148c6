"""Independent reference for valves: explicit ODEs in NumPy, solved by SciPy.

Nothing here reads Modelica text: the equations are written from their physics, with the fluid and the laws
of flow of `reference_main_regulator`, and the values come in as dictionaries.

Every valve is a spool, m dv/dt = forces - F_0 - c s - d v + stops, with chambers and volumes::

    dp/dt = K / V (sum(m) / rho - dV/dt)

and edges that open with its position, whose jets pull them shut. A solenoid valve has a coil as well::

    R i_cmd = R i + L di/dt + k_F v,   force k_F i
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
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

Model = Callable[[float, Array], list[float]]
P_0 = 101325.0
COMMON: dict[str, float] = {**DEFAULTS, "R": 5.0, "L": 0.01, "c_stop": 1e6, "b_stop": 1.0, "p_supply": 10.5e5}


def parameters(**values: float) -> Parameters:
    """The values that all valves share, with those of one."""
    return {**COMMON, **values}


LINEAR_SOLENOID = parameters(
    k_F=30.0,
    m=5e-3,
    c=15e3,
    d=15.0,
    F_preload=-1.0,
    s_max=0.4e-3,
    s_supply=0.055e-3,
    s_drain=0.07e-3,
    d_edge=8e-3,
    coverage=0.3,
    V_out=100e-6,
    d_load=0.6e-3,
    A_feedback=32e-6,
    V_feedback=1e-6,
    d_feedback=1e-3,
)
SHIFT_SOLENOID = parameters(
    k_F=8.0,
    m=20e-3,
    c=500.0,
    d=2.25,
    F_preload=2.0,
    s_max=3e-3,
    c_stop=1e7,
    b_stop=50.0,
    s_supply=1.8e-3,
    s_drain=1.2e-3,
    d_edge=4e-3,
    coverage=0.25,
    V_out=20e-6,
    d_load=0.6e-3,
)
LOCKUP_CONTROL = parameters(
    m=1e-3,
    c=5e3,
    d=50.0,
    F_preload=20.0,
    s_max=1e-3,
    s_supply=0.3e-3,
    s_drain=0.3e-3,
    d_edge=12e-3,
    coverage=0.1,
    V_out=200e-6,
    d_load=1e-3,
    A_feedback=100e-6,
    V_feedback=5e-6,
    d_feedback=2.5e-3,
    A_command=150e-6,
    V_command=8e-6,
    d_command=3e-3,
)
SWITCH_VALVE = parameters(
    m=10e-3,
    c=2e3,
    d=5.0,
    F_preload=20.0,
    s_max=4e-3,
    b_stop=20.0,
    s_supply=2.2e-3,
    s_drain=1.8e-3,
    d_edge=10e-3,
    coverage=0.3,
    V_out=50e-6,
    d_load=1e-3,
    A_pilot=78.5e-6,
    A_latch=10e-6,
    V_latch=0.5e-6,
)
CUT_VALVE = parameters(**SWITCH_VALVE, s_cut=2.2e-3, d_cut=10e-3, coverage_cut=0.06, p_line=8e5)
CONVERTER_REGULATOR = parameters(
    m=1e-3,
    c=2e3,
    d=50.0,
    F_preload=100.0,
    s_max=3e-3,
    overlap=0.3e-3,
    d_edge=20e-3,
    coverage=0.45,
    jet_angle=1.35,
    V_in=500e-6,
    d_load=1.5e-3,
    p_drain=3e5,
    A_1=300e-6,
    V_1=15e-6,
    d_1=4e-3,
    A_2=100e-6,
    V_2=6e-6,
    d_2=2e-3,
)
_LUBRICATION = {
    "c": 1.5e3,
    "F_preload": 80.0,
    "d_edge": 22e-3,
    "coverage": 0.4,
    "jet_angle": 1.4,
    "d_load": 2e-3,
}
LUBRICATION_REGULATOR = {**CONVERTER_REGULATOR, **_LUBRICATION, "A_1": 400e-6, "V_1": 20e-6}
ACCUMULATOR = parameters(
    m=1e-3, c=20e3, d=50.0, F_preload=300.0, s_max=15e-3, A=500e-6, V=10e-6, d_orifice=2e-3
)
TWO_WAY_CLUTCH = parameters(
    m=50e-3,
    c=0.0,
    d=10.0,
    F_preload=0.0,
    s_max=8e-3,
    b_stop=5.0,
    A=40e-6,
    V=2e-6,
    d_orifice=1.5e-3,
    hump=1e-3,
    F_detent=15.0,
    c_detent=10e3,
    d_detent=5.0,
    c_contact=1e6,
)


def ramp(time: float, step: tuple[float, float, float, float]) -> float:
    """Smooth step (start [s], duration [s], first value, last value)."""
    return step[2] + (step[3] - step[2]) * smooth_step((time - step[0]) / step[1])


def sharp_edge(opening: float, p_a: float, p_b: float, par: Parameters) -> tuple[float, float]:
    """Mass flow from a to b [kg/s] and closing force of the jet [N] of an edge without chamfer."""
    gap = 0.5 * (opening + np.sqrt(opening**2 + 4.0 * par["clearance"] ** 2))
    area = np.pi * par["d_edge"] * par["coverage"] * gap
    flow = restriction(p_a, p_b, area, 2.0 * gap, par["C_d_edge"], par["Re_crit_edge"], par)
    rho = density(0.5 * (p_a + p_b), par)
    return flow, float(flow**2 * np.cos(par["jet_angle"]) / (rho * par["C_d_edge"] * area))


def orifice(p_a: float, p_b: float, diameter: float, par: Parameters) -> float:
    """Mass flow from a to b through a bore [kg/s]."""
    return restriction(p_a, p_b, 0.25 * np.pi * diameter**2, diameter, par["C_d"], par["Re_crit"], par)


def acceleration(s: float, v: float, force: float, par: Parameters) -> float:
    """Of the spool under `force` [N], with spring, damping and elastic stops at 0 and s_max."""
    low = par["c_stop"] * max(0.0, -s) * max(0.0, 1.0 - par["b_stop"] * v)
    high = par["c_stop"] * max(0.0, s - par["s_max"]) * max(0.0, 1.0 + par["b_stop"] * v)
    return (force - par["F_preload"] - par["c"] * s - par["d"] * v + low - high) / par["m"]


def rest(par: Parameters) -> float:
    """Position of the spool without pressure."""
    if par["F_preload"] > 0:
        return -par["F_preload"] / (par["c"] + par["c_stop"])
    return -par["F_preload"] / par["c"] if par["c"] else 0.0


def rate(p: float, volume: float, mass_in: float, grows: float, par: Parameters) -> float:
    """Rise of the pressure in a volume that takes a mass flow and grows [Pa/s]."""
    return bulk_modulus(p, par) / volume * (mass_in / density(p, par) - grows)


def three_way(s: float, p_out: float, par: Parameters) -> tuple[float, float]:
    """Mass flow into the outlet, less that of the load, and force of the jets on the spool."""
    supplied, closing = sharp_edge(s - par["s_supply"], par["p_supply"], p_out, par)
    drained, opening = sharp_edge(par["s_drain"] - s, p_out, P_0, par)
    return supplied - drained - orifice(p_out, P_0, par["d_load"], par), opening - closing


def linear_solenoid(par: Parameters, current: tuple[float, float, float, float]) -> Model:
    """States i, s, v, p_feedback, p_out."""

    def derivative(time: float, y: Array) -> list[float]:
        i, s, v, p_fb, p = map(float, y)
        mass, jets = three_way(s, p, par)
        back = orifice(p, p_fb, par["d_feedback"], par)
        area = par["A_feedback"]
        force = par["k_F"] * i - area * (p_fb - P_0) + jets
        return [
            (par["R"] * (ramp(time, current) - i) - par["k_F"] * v) / par["L"],
            v,
            acceleration(s, v, force, par),
            rate(p_fb, par["V_feedback"] - area * s, back, -area * v, par),
            rate(p, par["V_out"], mass - back, 0.0, par),
        ]

    return derivative


def shift_solenoid(par: Parameters, current: tuple[float, float, float, float]) -> Model:
    """States i, s, v, p_out."""

    def derivative(time: float, y: Array) -> list[float]:
        i, s, v, p = map(float, y)
        mass, jets = three_way(s, p, par)
        return [
            (par["R"] * (ramp(time, current) - i) - par["k_F"] * v) / par["L"],
            v,
            acceleration(s, v, par["k_F"] * i + jets, par),
            rate(p, par["V_out"], mass, 0.0, par),
        ]

    return derivative


def lockup_control(par: Parameters, command: tuple[float, float, float, float]) -> Model:
    """States s, v, p_out, p_feedback, p_command."""

    def derivative(time: float, y: Array) -> list[float]:
        s, v, p, p_fb, p_cmd = map(float, y)
        mass, jets = three_way(s, p, par)
        back = orifice(p, p_fb, par["d_feedback"], par)
        told = orifice(ramp(time, command), p_cmd, par["d_command"], par)
        closes, opens = par["A_feedback"], par["A_command"]
        force = opens * (p_cmd - P_0) - closes * (p_fb - P_0) + jets
        return [
            v,
            acceleration(s, v, force, par),
            rate(p, par["V_out"], mass - back, 0.0, par),
            rate(p_fb, par["V_feedback"] - closes * s, back, -closes * v, par),
            rate(p_cmd, par["V_command"] + opens * s, told, opens * v, par),
        ]

    return derivative


def cut_valve(par: Parameters, pilot: tuple[float, float, float, float]) -> Model:
    """States s, v, p_out: a switch valve whose spool also feels the jets that drain four lines."""
    drains = {**par, "d_edge": par["d_cut"], "coverage": par["coverage_cut"]}
    switch = switch_valve(par, pilot)

    def derivative(time: float, y: Array) -> list[float]:
        v, dv, dp = switch(time, y)
        jet = sharp_edge(float(y[0]) - par["s_cut"], par["p_line"], P_0, drains)[1]
        return [v, dv - 4 * jet / par["m"], dp]

    return derivative


def switch_valve(par: Parameters, pilot: tuple[float, float, float, float]) -> Model:
    """States s, v, p_out; the latch's chamber is one volume with the outlet."""

    def derivative(time: float, y: Array) -> list[float]:
        s, v, p = map(float, y)
        mass, jets = three_way(s, p, par)
        area = par["A_latch"]
        force = par["A_pilot"] * (ramp(time, pilot) - P_0) + area * (p - P_0) + jets
        volume = par["V_out"] + par["V_latch"] + area * s
        return [v, acceleration(s, v, force, par), rate(p, volume, mass, area * v, par)]

    return derivative


def fed(flow: float, p: float, par: Parameters) -> float:
    """Mass flow through a laminar feed [kg/s]: the volume flow at the density before it, by iteration."""
    slope = np.pi * 6e-3**4 / (128 * par["nu"] * 2.0)
    mass = flow * density(p, par)
    for _ in range(20):
        mass = flow * density(p + mass / slope, par)
    return mass


def lubrication_regulator(par: Parameters, supply: tuple[float, float, float, float]) -> Model:
    """States s, v, p, p_1; `supply` is the volume flow at the far end of a laminar feed."""

    def derivative(time: float, y: Array) -> list[float]:
        s, v, p, p_1 = map(float, y)
        relief, jet = sharp_edge(s - par["overlap"], p, P_0, par)
        feedback, area = orifice(p, p_1, par["d_1"], par), par["A_1"]
        mass = fed(ramp(time, supply), p, par) - relief - feedback - orifice(p, P_0, par["d_load"], par)
        return [
            v,
            acceleration(s, v, area * (p_1 - P_0) - jet, par),
            rate(p, par["V_in"], mass, 0.0, par),
            rate(p_1, par["V_1"] + area * s, feedback, area * v, par),
        ]

    return derivative


def converter_regulator(par: Parameters, supply: tuple[float, float, float, float]) -> Model:
    """States s, v, p, p_1, p_2; `supply` is the volume flow at the far end of a laminar feed."""

    def derivative(time: float, y: Array) -> list[float]:
        s, v, p, p_1, p_2 = map(float, y)
        relief, jet = sharp_edge(s - par["overlap"], p, par["p_drain"], par)
        first = orifice(p, p_1, par["d_1"], par)
        second = orifice(p, p_2, par["d_2"], par)
        load = orifice(p, P_0, par["d_load"], par)
        opens, closes = par["A_1"], par["A_2"]
        force = opens * (p_1 - P_0) - closes * (p_2 - P_0) - jet
        mass = fed(ramp(time, supply), p, par) - relief - first - second - load
        return [
            v,
            acceleration(s, v, force, par),
            rate(p, par["V_in"], mass, 0.0, par),
            rate(p_1, par["V_1"] + opens * s, first, opens * v, par),
            rate(p_2, par["V_2"] - closes * s, second, -closes * v, par),
        ]

    return derivative


def accumulator(par: Parameters, line: tuple[float, float, float, float]) -> Model:
    """States s, v, p."""

    def derivative(time: float, y: Array) -> list[float]:
        s, v, p = map(float, y)
        taken = orifice(ramp(time, line), p, par["d_orifice"], par)
        area = par["A"]
        return [
            v,
            acceleration(s, v, area * (p - P_0), par),
            rate(p, par["V"] + area * s, taken, area * v, par),
        ]

    return derivative


def two_way_clutch(par: Parameters, drive: tuple[float, float, float, float]) -> Model:
    """States s, v, pressure in the drive chambers, in the reverse chambers, compression of the detents."""

    def derivative(time: float, y: Array) -> list[float]:
        s, v, p_d, p_r, z = map(float, y)
        area, stroke = par["A"], par["s_max"]
        phase = 2.0 * np.pi * s / stroke
        height = 0.5 * par["hump"] * (1.0 - np.cos(phase))
        pushed = max(0.0, par["c_contact"] * (height - z))
        cam = 0.5 * par["hump"] * 2.0 * np.pi / stroke * np.sin(phase)
        spring = par["F_detent"] + par["c_detent"] * (z + par["F_detent"] / par["c_contact"])
        into_drive = orifice(ramp(time, drive), p_d, par["d_orifice"], par)
        into_reverse = orifice(P_0, p_r, par["d_orifice"], par)
        return [
            v,
            acceleration(s, v, float(2.0 * area * (p_d - p_r) - 2.0 * pushed * cam), par),
            rate(p_d, par["V"] + area * s, into_drive, area * v, par),
            rate(p_r, par["V"] + area * (stroke - s), into_reverse, -area * v, par),
            float((pushed - spring) / par["d_detent"]),
        ]

    return derivative


def solve(model: Model, start: Mapping[str, float], stop_time: float, points: int) -> dict[str, Array]:
    """States over evenly spaced points, by name; the name's first letter tells their scale."""
    scales = {"i": 1.0, "s": 1e-3, "v": 1.0, "p": 1e5, "z": 1e-3}
    result = cast(
        "Any",
        solve_ivp(
            model,
            (0.0, stop_time),
            list(start.values()),
            method="LSODA",
            t_eval=np.linspace(0.0, stop_time, points),
            rtol=1e-8,
            atol=[1e-9 * scales[name[0]] for name in start],
        ),
    )
    assert result.success, result.message
    return dict(zip(start, result.y, strict=True))
