"""The converter's equations written out by hand, integrated by SciPy: what the models are compared with.

One ring at a time, one direction of flow at a time, as the equations stand in the specification of the
transmission; nothing is shared with the package.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from math import cos, radians, sqrt, tan

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

Array = NDArray[np.float64]
Time = Callable[[float], float]

DATA: dict[str, float] = {
    "R_p": 0.1105,
    "R_t": 0.0668,
    "R_s": 0.0605,
    "A": 0.0097,
    "a_p": radians(18.01),
    "a_t": radians(-59.04),
    "a_s": radians(59.54),
    "b_p": 0.0,
    "b_t": radians(40),
    "b_s": 0.0,
    "S_p": -0.001,
    "S_t": -0.00002,
    "S_s": 0.002,
    "L_f": 0.28,
    "I_p": 0.092,
    "I_t": 0.026,
    "I_s": 0.012,
    "rho": 840.0,
    "C_p": 1.0,
    "C_t": 1.0,
    "C_s": 1.0,
    "f": 0.2,
    "Q_0": 1e-4,
    "d_s": 1e-6,
}


def ramp(u: float) -> float:
    """The smooth step of degree five."""
    return 0.0 if u <= 0 else 1.0 if u >= 1 else u**3 * (10 - 15 * u + 6 * u * u)


def _flows(d: Mapping[str, float], Q: float) -> tuple[float, float, float]:
    """Share of forward flow, forward and backward part."""
    u = (Q + d["Q_0"]) / (2 * d["Q_0"])
    if u >= 1:
        return 1.0, Q, 0.0
    if u <= 0:
        return 0.0, 0.0, -Q
    forward = 2 * d["Q_0"] * (u**6 - 3 * u**5 + 2.5 * u**4)
    return ramp(u), forward, forward - Q


def torques_and_pressure(
    d: Mapping[str, float], Q: float, w_p: float, w_t: float, w_s: float
) -> tuple[float, float, float, float]:
    """Steady torques of the three rings and the net pressure."""
    u = Q / d["A"]
    rp, rt, rs = d["R_p"], d["R_t"], d["R_s"]
    share, q, r = _flows(d, Q)
    # forward: p -> t -> s -> p
    fp = w_p * rp**2 + rp * u * tan(d["a_p"]) - w_s * rs**2 - rs * u * tan(d["a_s"])
    ft = w_t * rt**2 + rt * u * tan(d["a_t"]) - w_p * rp**2 - rp * u * tan(d["a_p"])
    fs = w_s * rs**2 + rs * u * tan(d["a_s"]) - w_t * rt**2 - rt * u * tan(d["a_t"])
    vp = rs * (w_s - w_p) + u * (tan(d["a_s"]) - tan(d["b_p"]))
    vt = rp * (w_p - w_t) + u * (tan(d["a_p"]) - tan(d["b_t"]))
    vs = rt * (w_t - w_s) + u * (tan(d["a_t"]) - tan(d["b_s"]))
    walls = (u / cos(d["a_p"])) ** 2 + (u / cos(d["a_t"])) ** 2 + (u / cos(d["a_s"])) ** 2
    loss = (d["C_p"] * vp**2 + d["C_t"] * vt**2 + d["C_s"] * vs**2 + d["f"] * walls) / 2
    net_forward = fp * w_p + ft * w_t + fs * w_s - loss
    # backward: p -> s -> t -> p
    bp = w_p * rs**2 + rs * u * tan(d["b_p"]) - w_t * rp**2 - rp * u * tan(d["b_t"])
    bs = w_s * rt**2 + rt * u * tan(d["b_s"]) - w_p * rs**2 - rs * u * tan(d["b_p"])
    bt = w_t * rp**2 + rp * u * tan(d["b_t"]) - w_s * rt**2 - rt * u * tan(d["b_s"])
    vp = rp * (w_t - w_p) + u * (tan(d["b_t"]) - tan(d["a_p"]))
    vs = rs * (w_p - w_s) + u * (tan(d["b_p"]) - tan(d["a_s"]))
    vt = rt * (w_s - w_t) + u * (tan(d["b_s"]) - tan(d["a_t"]))
    walls = (u / cos(d["b_p"])) ** 2 + (u / cos(d["b_t"])) ** 2 + (u / cos(d["b_s"])) ** 2
    loss = (d["C_p"] * vp**2 + d["C_t"] * vt**2 + d["C_s"] * vs**2 + d["f"] * walls) / 2
    net_backward = bp * w_p + bt * w_t + bs * w_s - loss
    rho = d["rho"]
    return (
        rho * (q * fp + r * bp),
        rho * (q * ft + r * bt),
        rho * (q * fs + r * bs),
        rho * (share * net_forward - (1 - share) * net_backward),
    )


def stator(d: Mapping[str, float], Q: float, w_p: float, w_t: float) -> float:
    """Steady speed of the stator: 0, or where its torque and the drag cancel (the torque is linear in it)."""
    at_0 = torques_and_pressure(d, Q, w_p, w_t, 0.0)[2]
    at_1 = torques_and_pressure(d, Q, w_p, w_t, 1.0)[2]
    return max(0.0, -at_0 / (at_1 - at_0 + d["d_s"]))


def steady_flow(d: Mapping[str, float], w_p: float, w_t: float, low: float, high: float) -> float:
    """The flow between two bounds at which the net pressure vanishes."""

    def pressure(Q: float) -> float:
        return torques_and_pressure(d, Q, w_p, w_t, stator(d, Q, w_p, w_t))[3]

    return float(brentq(pressure, low, high, xtol=1e-15, rtol=1e-14))


def steady(d: Mapping[str, float], w_p: float, w_t: float, low: float = 1e-2) -> tuple[float, float, float]:
    """Torque ratio, K in rpm/sqrt(N.m) and flow on the branch with flows above `low`."""
    Q = steady_flow(d, w_p, w_t, low, 0.3)
    tau_p, tau_t, _, _ = torques_and_pressure(d, Q, w_p, w_t, stator(d, Q, w_p, w_t))
    return -tau_t / tau_p, w_p * 30 / np.pi / sqrt(tau_p), Q


def transient(
    level: int, torque: Time, speed: Time, rate: Time, start: Mapping[str, float], times: Array
) -> dict[str, Array]:
    """w_p, w_s and Q under the impeller's torque and the turbine's speed (and its rate) at level 1 or 2."""
    d = DATA

    def accelerations(t: float, y: Array, held: bool) -> tuple[Array, float]:
        """d(w_p, w_s, Q)/dt, and the torque that holds the stator."""
        w_p, w_s = float(y[0]), float(y[1])
        w_t = speed(t)
        Q = float(y[2]) if level == 1 else steady_flow(d, w_p, w_t, 5e-3, 0.3)
        h_p, _, h_s, pressure = torques_and_pressure(d, Q, w_p, w_t, w_s)
        s_p, s_t, s_s = (d["rho"] * d[name] if level == 1 else 0.0 for name in ("S_p", "S_t", "S_s"))
        flow = [s_p, 0 if held else s_s, d["rho"] * d["L_f"] / d["A"]] if level == 1 else [0, 0, 1.0]
        matrix = np.array([[d["I_p"], 0, s_p], [0, 1.0, 0] if held else [0, d["I_s"], s_s], flow])
        drag = h_s + d["d_s"] * w_s
        forces = [torque(t) - h_p, 0 if held else -drag, pressure - s_t * rate(t) if level == 1 else 0]
        out: Array = np.asarray(np.linalg.solve(matrix, np.array(forces, np.float64)), np.float64)
        return out, float(drag + s_s * out[2])

    names = ("w_p", "w_s", "Q")
    y: Array = np.array([start[name] for name in names], np.float64)
    held, now = True, float(times[0])
    rows: list[Array] = []
    while now < times[-1]:

        def rates(t: float, z: Array, held: bool = held) -> Array:
            return accelerations(t, z, held)[0]

        def change(t: float, z: Array, held: bool = held) -> float:
            return accelerations(t, z, True)[1] if held else float(z[1])

        change.terminal = True  # type: ignore[attr-defined]
        change.direction = -1.0  # type: ignore[attr-defined]
        ahead = times[times >= now - 1e-12] if not rows else times[times > now]
        part = solve_ivp(
            rates, (now, float(times[-1])), y, "LSODA", t_eval=ahead, events=change, rtol=1e-8, atol=1e-11
        )
        rows.append(np.asarray(part.y, np.float64))
        if part.status != 1:
            break
        assert part.t_events is not None
        assert part.y_events is not None
        now, y = float(part.t_events[0][0]), np.asarray(part.y_events[0][0], np.float64)
        held = not held
        y[1] = 0.0 if held else max(float(y[1]), 0.0)
    table = np.concatenate(rows, axis=1)
    if level == 2:
        table[2] = [steady_flow(d, w, speed(t), 5e-3, 0.3) for w, t in zip(table[0], times, strict=True)]
    return dict(zip(names, table, strict=True))
