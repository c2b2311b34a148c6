"""Steady states with speed or torque prescribed at either shaft, for arrays of points and parameters.

With both speeds given the flow is bracketed on a grid (`flow`). Otherwise the solutions are followed along
the flow: at a given flow the net pressure falls as the turbine gains on the impeller, so there is one pair of
speeds, up to a common factor; what the shafts prescribe then changes sign between two flows of the grid, is
closed in by bisection, and finished by Newton's method on the exact equations. This finds solutions on the
middle branch too, which no speeds alone could hold.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, fields, replace
from typing import get_args

import numpy as np
from numpy.typing import NDArray

from acausal.errors import UsageProblem, fail
from acausal.study.converter.flow import Choice, flow_at
from acausal.study.converter.geometry import NAMES, Array, Geometry, numbers
from acausal.study.converter.laws import balance

Strings = NDArray[np.str_]
_UNIT = 200.0
_GRID = 24
_BISECTIONS = 34
_EDGE = 26
_REFINEMENTS = 22
_CHUNK = 250
_ACCEPTED = 1e-6
_SOLVED = 1e-10
_LARGEST = 1e6
"""rad/s or N.m."""


@dataclass(frozen=True, eq=False)
class _Family:
    """Directions of the speeds, as angles of (w_p, w_t), between which the net pressure vanishes."""

    positive: Array
    """Where it is positive."""
    negative: Array


_FAMILIES = (
    _Family(np.linspace(-0.78, 0.3, 13), np.linspace(0.79, 1.65, 10)),
    _Family(np.linspace(-0.78, 0.3, 13), np.linspace(-1.7, -0.8, 10)),
    _Family(np.linspace(1.9, 2.7, 9), np.linspace(1.3, 1.9, 7)),
)
"""Both shafts forward; the turbine backward; the impeller backward."""


@dataclass(frozen=True, eq=False)
class Operating:
    """What the shafts prescribe: one entry of each pair, SI units; the turbine's torque counts out of it.

    Raises UsageProblem `converter.prescribed`, `converter.not-a-number`, `converter.out-of-range`.
    """

    impeller_speed: Array | None = None
    impeller_torque: Array | None = None
    turbine_speed: Array | None = None
    turbine_torque: Array | None = None

    def __post_init__(self) -> None:
        for shaft in ("impeller", "turbine"):
            if (getattr(self, f"{shaft}_speed") is None) == (getattr(self, f"{shaft}_torque") is None):
                message = f"prescribe either the speed or the torque of the {shaft}"
                raise fail(UsageProblem, "converter.prescribed", message)
        for field in fields(self):
            given = getattr(self, field.name)
            if given is not None:
                object.__setattr__(self, field.name, numbers(field.name, given, _LARGEST))

    @property
    def size(self) -> int:
        entries = (self.impeller_speed, self.impeller_torque, self.turbine_speed, self.turbine_torque)
        return max(np.size(entry) for entry in entries if entry is not None)


@dataclass(frozen=True, eq=False)
class SteadyState:
    """A solution per point. Where there is none, `branch` is `none` and the residual infinite."""

    impeller_speed: Array
    turbine_speed: Array
    stator_speed: Array
    impeller_torque: Array
    turbine_torque: Array
    flow: Array
    residual: Array
    """The larger of: net pressure over the sum of its terms' magnitudes, and what misses the prescribed."""
    branch: Strings
    """`converter` (stator held), `coupling` (stator free), `still` (|Q| < Q_0), `overrun` (reverse flow,
    stator free), `overrun held`; followed by `, upper` or `, lower` where there are several stable flows at
    these speeds, and by `, middle` where the flow is not stable at given speeds."""


def steady_state(geometry: Geometry, at: Operating, choice: Choice = "upper") -> SteadyState:
    """The steady state on the branch that continues from lower speed ratios (`upper`), or from higher ones.

    Arrays of all points have one size, or size 1. Where torques are prescribed, solutions are sought in which
    both shafts turn forward, then those in which one of them turns backward; where there is none (torques
    whose ratio no speeds have) the branch is `none`.

    Raises UsageProblem `converter.sizes`, `converter.choice`.
    """
    if choice not in get_args(Choice):
        message = f"there is no branch `{choice}` to choose"
        raise fail(UsageProblem, "converter.choice", message, hint="choose upper or lower")
    size = max(at.size, *(int(getattr(geometry, name).size) for name in NAMES))
    g = Geometry(**{name: _full(getattr(geometry, name), size) for name in NAMES})
    entries = (at.impeller_speed, at.impeller_torque, at.turbine_speed, at.turbine_torque)
    wanted = _Wanted(*(None if entry is None else _full(entry, size) for entry in entries))
    if wanted.w_p is not None and wanted.w_t is not None:
        return _finish(wanted.w_p, wanted.w_t, flow_at(wanted.w_p, wanted.w_t, g, choice).Q, g, wanted)
    points = np.full((size, 3), np.nan)
    for family in _FAMILIES:
        missing = np.flatnonzero(~(_worst(points, g, wanted) < _SOLVED))
        for first in range(0, len(missing), _CHUNK):
            part = np.isin(np.arange(size), missing[first : first + _CHUNK])
            found = _follow(g.take(part), wanted.take(part), choice, family)
            points[part] = _newton(found, g.take(part), wanted.take(part))
    return _finish(points[:, 0], points[:, 1], points[:, 2], g, wanted)


def _full(entry: Array, size: int) -> Array:
    if np.size(entry) not in (1, size):
        message = f"{np.size(entry)} entries do not go with {size} of another parameter or shaft"
        raise fail(
            UsageProblem, "converter.sizes", message, hint="give one entry for all points, or one for each"
        )
    return np.broadcast_to(np.asarray(entry, np.float64), size).copy()


@dataclass(frozen=True, eq=False)
class _Wanted:
    """What is prescribed, broadcast to all points; the turbine's torque counts out of it."""

    w_p: Array | None
    tau_p: Array | None
    w_t: Array | None
    tau_t: Array | None

    def take(self, where: NDArray[np.bool_]) -> _Wanted:
        return self._each(lambda values: values[where])

    def column(self) -> _Wanted:
        return self._each(lambda values: values[:, None])

    def _each(self, change: Callable[[Array], Array]) -> _Wanted:
        entries = (self.w_p, self.tau_p, self.w_t, self.tau_t)
        return _Wanted(*(None if values is None else change(values) for values in entries))

    def scale(self) -> Array:
        """A guess of the common size of both speeds."""
        speeds = [np.abs(w) for w in (self.w_p, self.w_t) if w is not None]
        torques = [_UNIT * np.sqrt(np.abs(tau) / 140) for tau in (self.tau_p, self.tau_t) if tau is not None]
        return np.maximum(np.maximum.reduce([*speeds, *torques]), 1.0)

    def miss(self, angle: Array, tau_p: Array, tau_t: Array) -> Array:
        """Changes sign where a direction of speeds, with its torques at the unit of speed, can be scaled."""
        if self.tau_p is not None and self.tau_t is not None:
            return tau_p * self.tau_t + tau_t * self.tau_p
        if self.tau_p is not None:
            assert self.w_t is not None
            s = _UNIT * np.sin(angle)
            return self.tau_p * s * np.abs(s) - self.w_t * np.abs(self.w_t) * tau_p
        assert self.w_p is not None
        assert self.tau_t is not None
        c = _UNIT * np.cos(angle)
        return self.tau_t * c * np.abs(c) + self.w_p * np.abs(self.w_p) * tau_t

    def factor(self, angle: Array, tau_p: Array, tau_t: Array) -> Array:
        """The size of both speeds that fits, from what determines it best."""
        tau, unit = (self.tau_p, tau_p) if self.tau_p is not None else (self.tau_t, -tau_t)
        assert tau is not None
        by_torque = _UNIT * np.sqrt(np.maximum(tau / np.where(unit == 0, np.inf, unit), 0))
        if self.w_t is not None:
            share = np.sin(angle)
            return np.where(np.abs(share) > 0.1, self.w_t / np.where(share == 0, 1, share), by_torque)
        if self.w_p is not None:
            share = np.cos(angle)
            return np.where(np.abs(share) > 0.1, self.w_p / np.where(share == 0, 1, share), by_torque)
        return by_torque


def _follow(g: Geometry, wanted: _Wanted, choice: Choice, family: _Family) -> Array:
    """A point (w_p, w_t, Q) close to the solution; not-a-number where there is none."""
    scale = wanted.scale()
    point = np.full((len(scale), 3), np.nan)
    for _ in range(2):  # the second time with small flow and drag in proportion to the speeds found
        unit = replace(g, Q_0=g.Q_0 * _UNIT / scale, d_s=g.d_s * _UNIT / scale)
        point = _at_unit(unit, wanted, choice, family)
        found = np.hypot(point[:, 0], point[:, 1])
        scale = np.where(np.isfinite(found) & (found > 0), found, scale)
    return point


def _at_unit(g: Geometry, wanted: _Wanted, choice: Choice, family: _Family) -> Array:
    shape = np.sort(np.concatenate([c := (np.arange(-_GRID, _GRID + 1) / _GRID) ** 3, 1e-3 * c[1:-1:2]]))
    least, largest = (_last_flow(sign, g, family)[:, None] for sign in (-1.0, 1.0))
    nodes = np.where(shape < 0, -least * shape, largest * shape)
    values = _missed(nodes, g.column(), wanted.column(), family)[0]
    finite = np.isfinite(values[:, :-1]) & np.isfinite(values[:, 1:])
    changes = finite & ((values[:, :-1] > 0) != (values[:, 1:] > 0))
    exists = changes.any(axis=1)
    last = changes.shape[1] - 1 - np.argmax(changes[:, ::-1], axis=1)
    i = last if choice == "upper" else np.argmax(changes, axis=1)
    rows = np.arange(len(i))
    left, right = nodes[rows, i], nodes[rows, i + 1]
    positive = values[rows, i] > 0
    for _ in range(_REFINEMENTS):
        middle = (left + right) / 2
        same = (_missed(middle, g, wanted, family)[0] > 0) == positive
        left, right = np.where(same, middle, left), np.where(same, right, middle)
    Q = (left + right) / 2
    _, angle, tau_p, tau_t = _missed(Q, g, wanted, family)
    factor = np.where(exists, wanted.factor(angle, tau_p, tau_t), np.nan)
    return np.stack([factor * np.cos(angle), factor * np.sin(angle), factor / _UNIT * Q], axis=1)


def _missed(Q: Array, g: Geometry, wanted: _Wanted, family: _Family) -> tuple[Array, Array, Array, Array]:
    """How far what is prescribed is missed at a flow, the direction of speeds there, both torques."""
    angle = _angle(Q, g, family)
    found = balance(Q, _UNIT * np.cos(angle), _UNIT * np.sin(angle), g)[0]
    return wanted.miss(angle, found.tau_p, found.tau_t), angle, found.tau_p, found.tau_t


def _pressure(Q: Array, angle: Array, g: Geometry) -> Array:
    return balance(Q, _UNIT * np.cos(angle), _UNIT * np.sin(angle), g)[0].pressure


def _ends(Q: Array, g: Geometry, family: _Family) -> tuple[Array, Array, NDArray[np.bool_]]:
    """Directions with a high and with a low net pressure, and whether they are positive and negative."""
    first, last = (
        np.stack([_pressure(Q, np.full(Q.shape, angle), g) for angle in angles.tolist()])
        for angles in (family.positive, family.negative)
    )
    step = float(family.positive[1] - family.positive[0])
    highest = _top(family.positive[np.argmax(first, axis=0)], step, Q, g)
    high = np.maximum(first.max(axis=0), _pressure(Q, highest, g))
    return highest, family.negative[np.argmin(last, axis=0)], (high > 0) & (last.min(axis=0) < 0)


def _top(angle: Array, step: float, Q: Array, g: Geometry) -> Array:
    """The direction of the highest net pressure close to an angle: the vertex of two parabolas in turn."""
    for h in (step, step / 16):
        behind, here, ahead = (_pressure(Q, angle + k * h, g) for k in (-1, 0, 1))
        bend = 2 * here - behind - ahead
        angle = angle + h * np.clip((ahead - behind) / (2 * np.where(bend > 0, bend, np.inf)), -1, 1)
    return angle


def _last_flow(sign: float, g: Geometry, family: _Family) -> Array:
    """The largest flow in one direction that steady states have."""
    inside, outside = np.zeros(len(g.A)), sign * (g.A * g.R_p * _UNIT + 10 * g.Q_0)
    for _ in range(_EDGE):
        middle = (inside + outside) / 2
        exists = _ends(middle, g, family)[2]
        inside, outside = np.where(exists, middle, inside), np.where(exists, outside, middle)
    return inside


def _angle(Q: Array, g: Geometry, family: _Family) -> Array:
    """The direction of (w_p, w_t) in which the net pressure vanishes at the unit of speed; else nan."""
    positive, negative, inside = _ends(Q, g, family)
    for _ in range(_BISECTIONS):
        middle = (positive + negative) / 2
        above = _pressure(Q, middle, g) > 0
        positive, negative = np.where(above, middle, positive), np.where(above, negative, middle)
    return np.where(inside, (positive + negative) / 2, np.nan)


def _equations(x: Array, g: Geometry, wanted: _Wanted) -> Array:
    """Relative residuals of the three equations at (w_p, w_t, Q)."""
    found = balance(x[:, 2], x[:, 0], x[:, 1], g)[0]
    speed = np.maximum(np.hypot(x[:, 0], x[:, 1]), 1e-3)
    torque = np.maximum(np.maximum(np.abs(found.tau_p), np.abs(found.tau_t)), 1e-9)
    rows = [found.pressure / np.maximum(found.size, 1e-300)]
    for given, value, size in (
        (wanted.w_p, x[:, 0], speed),
        (wanted.tau_p, found.tau_p, torque),
        (wanted.w_t, x[:, 1], speed),
        (wanted.tau_t, -found.tau_t, torque),
    ):
        if given is not None:
            rows.append((value - given) / size)
    return np.stack(rows, axis=1)


def _newton(x: Array, g: Geometry, wanted: _Wanted) -> Array:
    """Newton's method with a Jacobian by differences; a step counts only where the residual falls."""
    with np.errstate(all="ignore"):
        worst = _worst(x, g, wanted)
        for _ in range(12):
            active = np.isfinite(worst) & (worst > 1e-13)
            if not active.any():
                break
            step = _step(x[active], g.take(active), wanted.take(active))
            for factor in (1.0, 0.25, 0.05):
                trial = x.copy()
                trial[active] += factor * step
                now = _worst(trial, g, wanted)
                better = now < worst
                x, worst = np.where(better[:, None], trial, x), np.where(better, now, worst)
    return x


def _worst(x: Array, g: Geometry, wanted: _Wanted) -> Array:
    residual = np.abs(_equations(x, g, wanted)).max(axis=1)
    return np.where(np.isfinite(residual), residual, np.inf)


def _step(x: Array, g: Geometry, wanted: _Wanted) -> Array:
    jacobian = np.empty((len(x), 3, 3))
    size = np.maximum(np.hypot(x[:, 0], x[:, 1]), 1e-3)
    for column, scale in enumerate((size, size, g.A * g.R_p * size * 1e-2 + g.Q_0)):
        h = np.zeros_like(x)
        h[:, column] = 1e-7 * scale
        ahead, behind = _equations(x + h, g, wanted), _equations(x - h, g, wanted)
        jacobian[:, :, column] = (ahead - behind) / (2e-7 * scale)[:, None]
    regular = np.abs(np.linalg.det(jacobian)) > 0
    jacobian[~regular] = np.eye(3)
    step = np.linalg.solve(jacobian, -_equations(x, g, wanted)[:, :, None])[:, :, 0]
    return np.where(regular[:, None], step, 0.0)


def _finish(w_p: Array, w_t: Array, flow: Array, g: Geometry, wanted: _Wanted) -> SteadyState:
    found, w_s = balance(flow, w_p, w_t, g)
    residual = np.abs(_equations(np.stack([w_p, w_t, flow], axis=1), g, wanted)).max(axis=1)
    residual = np.where(residual < _ACCEPTED, residual, np.inf)
    names = _names(w_p, w_t, w_s, flow, g)
    branch = np.where(np.isfinite(residual), names, "none")
    return SteadyState(w_p, w_t, w_s, found.tau_p, -found.tau_t, flow, residual, branch)


def _names(w_p: Array, w_t: Array, w_s: Array, flow: Array, g: Geometry) -> Strings:
    free = w_s > 0
    forward, backward = np.where(free, "coupling", "converter"), np.where(free, "overrun", "overrun held")
    regime = np.where(flow > 0, forward, backward)
    regime = np.where(np.abs(flow) < g.Q_0, "still", regime)
    usable = np.isfinite(flow) & np.isfinite(w_p) & np.isfinite(w_t)
    speeds = np.where(usable, w_p, 0.0), np.where(usable, w_t, 0.0)
    upper, lower = (flow_at(*speeds, g, choice) for choice in ("upper", "lower"))
    at_upper, at_lower = (np.abs(flow - Q) <= 1e-6 * np.abs(Q) + 1e-3 * g.Q_0 for Q in (upper.Q, lower.Q))
    several = upper.stable > 1
    suffix = np.where(at_upper, ", upper", np.where(at_lower, ", lower", ", middle"))
    return np.char.add(regime, np.where(several, suffix, ""))
