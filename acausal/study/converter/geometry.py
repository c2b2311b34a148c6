"""The parameters of the circuit, by the names of `TenSpeed.Converter.Geometry`; single numbers or arrays."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields, replace
from math import pi

import numpy as np
from numpy.typing import NDArray

from acausal.errors import UsageProblem, fail

Array = NDArray[np.float64]
_DEGREE = pi / 180


@dataclass(frozen=True, eq=False)
class Geometry:
    """SI units, angles in rad. Each entry is an array of one size, or of size 1."""

    R_p: Array
    R_t: Array
    R_s: Array
    A: Array
    a_p: Array
    a_t: Array
    a_s: Array
    b_p: Array
    b_t: Array
    b_s: Array
    C_p: Array
    C_t: Array
    C_s: Array
    f: Array
    rho: Array
    Q_0: Array
    d_s: Array

    @staticmethod
    def of(values: Mapping[str, float | Array]) -> Geometry:
        """The nominal circuit with some entries replaced.

        Raises UsageProblem `converter.unknown-parameter`, `converter.not-a-number`, `converter.out-of-range`.
        """
        unknown = [name for name in values if name not in NAMES]
        if unknown:
            raise fail(
                UsageProblem,
                "converter.unknown-parameter",
                f"the circuit has no parameter `{unknown[0]}`",
                names=unknown,
                hint=f"it has {', '.join(NAMES)}",
            )
        return replace(NOMINAL, **{name: _checked(name, value) for name, value in values.items()})

    def take(self, where: NDArray[np.bool_]) -> Geometry:
        """The entries of the chosen points."""
        arrays: dict[str, Array] = {name: getattr(self, name) for name in NAMES}
        return Geometry(**{name: v[where] if v.size > 1 else v for name, v in arrays.items()})

    def column(self) -> Geometry:
        """Every array as a column, to be combined with a row of grid points."""
        arrays: dict[str, Array] = {name: getattr(self, name) for name in NAMES}
        return Geometry(**{name: v[:, None] for name, v in arrays.items()})


def numbers(name: str, value: object, largest: float) -> Array:
    """A row of numbers, none larger than `largest`.

    Raises UsageProblem `converter.not-a-number`, `converter.out-of-range`.
    """
    try:
        row = np.atleast_1d(np.asarray(value, np.float64))
    except (TypeError, ValueError):
        row = np.array([np.nan])
    wrong = ~(np.abs(row) <= largest)
    if row.ndim > 1 or not row.size or np.isnan(row).any():
        what = "not a row of numbers" if row.ndim > 1 or not row.size else "not a number"
        raise fail(UsageProblem, "converter.not-a-number", f"`{name}` is {what}", names=[name])
    if wrong.any():
        raise out_of_range(name, float(row[wrong][0]), f"at most {largest:g} in magnitude")
    return row


def out_of_range(name: str, value: float, allowed: str) -> Exception:
    """The error for a number that no circuit has."""
    return fail(
        UsageProblem, "converter.out-of-range", f"`{name}` is {value:g}, it must be {allowed}", names=[name]
    )


def _checked(name: str, value: object) -> Array:
    """One parameter: sizes and density are positive, losses are not negative, blades not tangential."""
    row = numbers(name, value, 1e6)
    if name.startswith(("a_", "b_")) and (np.abs(row) > 0.49 * pi).any():
        raise out_of_range(name, float(row[np.abs(row) > 0.49 * pi][0]), "between -88 and 88 degrees, in rad")
    if name in _POSITIVE and (row <= 0).any():
        raise out_of_range(name, float(row[row <= 0][0]), "positive")
    if name in _NOT_NEGATIVE and (row < 0).any():
        raise out_of_range(name, float(row[row < 0][0]), "not negative")
    return row


_POSITIVE = ("R_p", "R_t", "R_s", "A", "rho", "Q_0", "d_s")
_NOT_NEGATIVE = ("C_p", "C_t", "C_s", "f")
NAMES = tuple(field.name for field in fields(Geometry))


def _nominal() -> Geometry:
    degrees = {"a_p": 18.01, "a_t": -59.04, "a_s": 59.54, "b_p": 0.0, "b_t": 40.0, "b_s": 0.0}
    others = {
        "R_p": 0.1105,
        "R_t": 0.0668,
        "R_s": 0.0605,
        "A": 0.0097,
        "C_p": 1.0,
        "C_t": 1.0,
        "C_s": 1.0,
        "f": 0.2,
        "rho": 840.0,
        "Q_0": 1e-4,
        "d_s": 1e-6,
    }
    values = {**{name: angle * _DEGREE for name, angle in degrees.items()}, **others}
    return Geometry(**{name: np.array([value]) for name, value in values.items()})


NOMINAL = _nominal()
"""The published converter of the 1980s that the models have as defaults."""

STUDY_RANGES: Mapping[str, float] = {
    **dict.fromkeys(("a_p", "a_t", "a_s", "b_p", "b_t", "b_s"), 2 * _DEGREE),
    "C_p": 0.15,
    "C_t": 0.1,
    "C_s": 0.15,
    "f": 0.05,
    "R_p": 0.005,
    "R_t": 0.005,
    "R_s": 0.005,
    "A": 0.002,
}
"""Half the width of each factor's range in the studies, about the nominal value."""
