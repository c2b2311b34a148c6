"""The laws of the circuit in steady flow, vectorised: `TenSpeed.Converter.Functions` in NumPy.

Flow Q is positive from impeller to turbine to stator. Within |Q| < Q_0 both directions are blended.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from acausal.study.converter.geometry import Array, Geometry


@dataclass(frozen=True, eq=False)
class Balance:
    """At given flow and speeds: torques on the oil (N.m), net pressure (Pa), and the size of its terms."""

    tau_p: Array
    tau_t: Array
    tau_s: Array
    pressure: Array
    size: Array

    @property
    def relative(self) -> Array:
        """The net pressure over the sum of the magnitudes of its terms."""
        return np.abs(self.pressure) / np.maximum(self.size, 1e-300)


@dataclass(frozen=True, eq=False)
class _Direction:
    """One direction of flow: torques over mass flow, losses over density, sum of torque times speed."""

    h_p: Array
    h_t: Array
    h_s: Array
    loss: Array
    power: Array
    size: Array


def shares(Q: Array, g: Geometry) -> tuple[Array, Array, Array]:
    """The share of the forward laws, the forward part of the flow, the backward part (both not negative)."""
    x = (Q + g.Q_0) / (2 * g.Q_0)
    u = np.clip(x, 0.0, 1.0)
    share = u**3 * (10 + u * (6 * u - 15))
    forward = 2 * g.Q_0 * np.where(x >= 1, x - 0.5, u**4 * (2.5 + u * (u - 3)))
    return share, forward, forward - Q


def stator_speed(Q: Array, w_p: Array, w_t: Array, g: Geometry) -> Array:
    """rad/s, at which a stator without one-way clutch turns: tau_s + d_s w_s = 0, linear in w_s."""
    _, q, r = shares(Q, g)
    u = Q / g.A
    forward = w_t * g.R_t**2 + u * (g.R_t * np.tan(g.a_t) - g.R_s * np.tan(g.a_s))
    backward = w_p * g.R_s**2 + u * (g.R_s * np.tan(g.b_p) - g.R_t * np.tan(g.b_s))
    return g.rho * (q * forward + r * backward) / (g.d_s + g.rho * (q * g.R_s**2 + r * g.R_t**2))


def balance(Q: Array, w_p: Array, w_t: Array, g: Geometry) -> tuple[Balance, Array]:
    """Torques and net pressure with the stator at its steady speed, and that speed, which is not negative."""
    w_s = np.maximum(stator_speed(Q, w_p, w_t, g), 0.0)
    return balance_at(Q, w_p, w_t, w_s, g), w_s


def balance_at(Q: Array, w_p: Array, w_t: Array, w_s: Array, g: Geometry) -> Balance:
    """Torques and net pressure at given speeds of all three rings."""
    share, q, r = shares(Q, g)
    f, b = _forward(Q, w_p, w_t, w_s, g), _backward(Q, w_p, w_t, w_s, g)
    net_f, net_b = f.power - f.loss, b.power - b.loss
    return Balance(
        g.rho * (q * f.h_p + r * b.h_p),
        g.rho * (q * f.h_t + r * b.h_t),
        g.rho * (q * f.h_s + r * b.h_s),
        g.rho * (share * net_f - (1 - share) * net_b),
        g.rho * (share * f.size + (1 - share) * b.size),
    )


def _forward(Q: Array, w_p: Array, w_t: Array, w_s: Array, g: Geometry) -> _Direction:
    u = Q / g.A
    t_p, t_t, t_s = np.tan(g.a_p), np.tan(g.a_t), np.tan(g.a_s)
    p = w_p * g.R_p**2 + g.R_p * u * t_p
    t = w_t * g.R_t**2 + g.R_t * u * t_t
    s = w_s * g.R_s**2 + g.R_s * u * t_s
    v_p = g.R_s * (w_s - w_p) + u * (t_s - np.tan(g.b_p))
    v_t = g.R_p * (w_p - w_t) + u * (t_p - np.tan(g.b_t))
    v_s = g.R_t * (w_t - w_s) + u * (t_t - np.tan(g.b_s))
    walls = g.f * u**2 * (np.cos(g.a_p) ** -2 + np.cos(g.a_t) ** -2 + np.cos(g.a_s) ** -2)
    loss = (g.C_p * v_p**2 + g.C_t * v_t**2 + g.C_s * v_s**2 + walls) / 2
    return _direction((p - s, t - p, s - t), (w_p, w_t, w_s), loss)


def _backward(Q: Array, w_p: Array, w_t: Array, w_s: Array, g: Geometry) -> _Direction:
    u = Q / g.A
    t_p, t_t, t_s = np.tan(g.b_p), np.tan(g.b_t), np.tan(g.b_s)
    p = w_p * g.R_s**2 + g.R_s * u * t_p
    t = w_t * g.R_p**2 + g.R_p * u * t_t
    s = w_s * g.R_t**2 + g.R_t * u * t_s
    v_p = g.R_p * (w_t - w_p) + u * (t_t - np.tan(g.a_p))
    v_s = g.R_s * (w_p - w_s) + u * (t_p - np.tan(g.a_s))
    v_t = g.R_t * (w_s - w_t) + u * (t_s - np.tan(g.a_t))
    walls = g.f * u**2 * (np.cos(g.b_p) ** -2 + np.cos(g.b_t) ** -2 + np.cos(g.b_s) ** -2)
    loss = (g.C_p * v_p**2 + g.C_t * v_t**2 + g.C_s * v_s**2 + walls) / 2
    return _direction((p - t, t - s, s - p), (w_p, w_t, w_s), loss)


def _direction(h: tuple[Array, Array, Array], w: tuple[Array, Array, Array], loss: Array) -> _Direction:
    terms = [one * speed for one, speed in zip(h, w, strict=True)]
    size = np.abs(terms[0]) + np.abs(terms[1]) + np.abs(terms[2]) + loss
    return _Direction(h[0], h[1], h[2], loss, terms[0] + terms[1] + terms[2], size)
