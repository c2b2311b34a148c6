"""Independent reference for the ten-speed's kinematics: linear algebra on tooth counts and inertias.

Eight bodies turn; every gearset and every engaged element is one linear constraint C w = 0. With the
diagonal inertia matrix M and the driving torques T, Lagrange's equations of the first kind read::

    [ M  C^T ] [ a      ]   [ T ]
    [ C   0  ] [ lambda ] = [ 0 ]

Nothing here reads Modelica text.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

BODIES = 8

#: Gearset: sun, carrier and ring body, teeth of sun and ring.
GEARSETS: dict[str, tuple[int, int, int, int, int]] = {
    "P1": (5, 4, 2, 42, 130),
    "P2": (3, 4, 8, 43, 81),
    "P3": (1, 2, 3, 37, 103),
    "P4": (6, 2, 7, 48, 76),
}

#: Element: the two bodies it couples; 0 is the case.
ELEMENTS: dict[str, tuple[int, int]] = {
    "C1": (1, 4),
    "C2": (3, 6),
    "C3": (1, 7),
    "B1": (5, 0),
    "B2": (6, 0),
    "B3": (7, 0),
    "F1": (4, 0),
}

#: Gear (-1 is reverse): engaged elements and published ratio w_1 / w_8.
GEARS: dict[int, tuple[str, float]] = {
    1: ("B1 B2 F1", 5.246),
    2: ("B1 B2 C2", 3.271),
    3: ("B1 B2 C3", 2.185),
    4: ("B1 C2 C3", 1.597),
    5: ("B1 C1 C3", 1.304),
    6: ("C1 C2 C3", 1.000),
    7: ("B2 C1 C3", 0.782),
    8: ("B2 C1 C2", 0.653),
    9: ("B2 B3 C1", 0.581),
    10: ("B3 C1 C2", 0.517),
    -1: ("B2 C3 F1", -3.974),
}

#: Inertias of bodies 1 to 8 [kg m2].
INERTIAS = (0.02, 0.03, 0.02, 0.015, 0.004, 0.004, 0.006, 0.02)

#: Vehicle as an inertia at the output gear: 1900 kg, tire 0.33 m, final drive 3.61 [kg m2].
VEHICLE_INERTIA = 1900.0 * (0.33 / 3.61) ** 2


def constraints(engaged: Sequence[str]) -> Array:
    """Rows C of C w = 0: w_sun + i w_ring - (1 + i) w_carrier, then w_a - w_b per engaged element."""
    rows: list[Array] = []
    for sun, carrier, ring, z_sun, z_ring in GEARSETS.values():
        ratio = z_ring / z_sun
        row = np.zeros(BODIES)
        row[sun - 1] += 1.0
        row[ring - 1] += ratio
        row[carrier - 1] -= 1.0 + ratio
        rows.append(row)
    for name in engaged:
        first, second = ELEMENTS[name]
        row = np.zeros(BODIES)
        row[first - 1] = 1.0
        if second:
            row[second - 1] = -1.0
        rows.append(row)
    return np.array(rows)


def speeds(gear: int) -> Array:
    """Speeds of bodies 1 to 8 for w_1 = 1 rad/s; raises `ValueError` unless one degree of freedom is left."""
    matrix = constraints(GEARS[gear][0].split())
    if np.linalg.matrix_rank(matrix) != BODIES - 1:
        raise ValueError(f"gear {gear} does not leave exactly one degree of freedom")
    null = np.linalg.svd(matrix)[2][-1]
    return np.asarray(null / null[0], dtype=np.float64)


def ratio(gear: int) -> float:
    """w_1 / w_8."""
    return float(1.0 / speeds(gear)[7])


def accelerations(
    gear: int,
    torque_in: float = 150.0,
    inertias: Sequence[float] = INERTIAS,
    load_inertia: float = VEHICLE_INERTIA,
) -> Array:
    """Accelerations of bodies 1 to 8 [rad/s2] under `torque_in` [N m] on body 1, `load_inertia` on body 8."""
    mass = np.diag(np.asarray(inertias, dtype=np.float64))
    mass[7, 7] += load_inertia
    matrix = constraints(GEARS[gear][0].split())
    count = matrix.shape[0]
    system = np.block([[mass, matrix.T], [matrix, np.zeros((count, count))]])
    load = np.zeros(BODIES + count)
    load[0] = torque_in
    return np.asarray(np.linalg.solve(system, load)[:BODIES], dtype=np.float64)


def main() -> None:
    """Print ratio, deviation from the published one and the accelerations in every gear."""
    for gear, (engaged, published) in GEARS.items():
        found = ratio(gear)
        bodies = np.round(accelerations(gear), 4)
        print(f"{gear:3d} {engaged:9s} {found:9.5f} {found - published:+.5f}", bodies)


if __name__ == "__main__":
    main()
