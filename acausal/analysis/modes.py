"""The modes of dx/dt = A x: eigenvalues, mode shapes, participation of the states.

Eigenvalues that agree within a tolerance are one *cluster*. A cluster may be defective (a free body: position
and speed share the eigenvalue 0 and only one mode shape); its single eigenvalues are then ill-conditioned,
but their mean and the invariant subspace of the cluster are not. So every mode here is a cluster, usually of
one eigenvalue, and participation comes from the cluster's spectral projector.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import inf, pi

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import matrix_balance, schur, solve_sylvester
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

Matrix = NDArray[np.float64]
Complex = NDArray[np.complex128]

CLUSTER = 1e-7
"""Eigenvalues closer than this, relative to the largest by magnitude, belong together."""
_ROUNDING = 1e3 * np.finfo(float).eps
"""Of a decomposition, relative to the norm of the matrix."""


@dataclass(frozen=True, eq=False)
class Mode:
    """A cluster of eigenvalues.

    `eigenvalue` is their mean. `shape` has one column per independent eigenvector, of unit length, the
    largest entry real and positive. `participation` sums to one over the states.
    """

    eigenvalue: complex
    multiplicity: int
    shape: Complex
    participation: NDArray[np.float64]

    @property
    def is_defective(self) -> bool:
        """Whether there are fewer eigenvectors than eigenvalues."""
        return self.shape.shape[1] < self.multiplicity

    @property
    def frequency_hz(self) -> float:
        """Natural frequency |lambda| / (2 pi)."""
        return abs(self.eigenvalue) / (2 * pi)

    @property
    def damping_ratio(self) -> float:
        """-Re(lambda) / |lambda|: 1 decays without swinging, 0 swings for ever, negative grows. 0 at 0."""
        size = abs(self.eigenvalue)
        return -self.eigenvalue.real / size if size else 0.0

    @property
    def time_constant(self) -> float:
        """-1 / Re(lambda) in seconds: negative where the mode grows, infinite where it stays."""
        return -1 / self.eigenvalue.real if self.eigenvalue.real else inf


@dataclass(frozen=True, eq=False)
class Modes:
    """All modes, slowest first; complex ones come in pairs, the one with positive imaginary part first."""

    modes: tuple[Mode, ...]
    condition: float
    """Condition number of the balanced eigenvector matrix; infinite where a cluster is defective."""

    @property
    def eigenvalues(self) -> Complex:
        """As many as states: each mode's, repeated by its multiplicity."""
        return np.array(
            [m.eigenvalue for m in self.modes for _ in range(m.multiplicity)], dtype=np.complex128
        )


def modes(a: Matrix, scale: Sequence[float] | NDArray[np.float64] | None = None) -> Modes:
    """The modes of a real square matrix.

    `scale` are typical sizes of the states; with them, or with balancing where they are missing, units do
    not matter. O(n^3). Raises ValueError for a matrix that is not square or not finite.
    """
    if a.ndim != 2 or a.shape[0] != a.shape[1] or not np.isfinite(a).all():
        raise ValueError("the modes of a matrix need it to be square and finite")
    n = a.shape[0]
    if n == 0:
        return Modes((), 1.0)
    sizes = np.ones(n) if scale is None else np.asarray(scale, dtype=np.float64)
    balanced, (factors, _) = matrix_balance(a / sizes[:, None] * sizes, permute=False, separate=True)
    back = sizes * factors
    triangle, basis = schur(balanced, output="complex")
    values = np.diag(triangle)
    found = _with_conjugates([_mode(triangle, basis, members, back) for members in _clusters(values)], n)
    found.sort(key=lambda mode: abs(mode.eigenvalue))
    return Modes(tuple(found), _condition(found, back))


def _with_conjugates(found: Sequence[Mode], n: int) -> list[Mode]:
    """Modes of a real matrix come in exactly conjugate pairs, the one with positive imaginary part first."""
    pairs: list[Mode] = []
    for mode in found:
        if mode.eigenvalue.imag >= 0:
            pairs.append(mode)
        if mode.eigenvalue.imag > 0:
            shape = mode.shape.conj()
            pairs.append(Mode(mode.eigenvalue.conjugate(), mode.multiplicity, shape, mode.participation))
    return pairs if sum(mode.multiplicity for mode in pairs) == n else list(found)


def _clusters(values: Complex) -> list[NDArray[np.intp]]:
    """Indices of eigenvalues that belong together: connected by steps below the tolerance."""
    tolerance = CLUSTER * max(float(np.abs(values).max()), np.finfo(float).tiny)
    order = np.argsort(values.real, kind="stable")
    ends = np.searchsorted(values.real[order], values.real[order] + tolerance, side="right")
    rows: list[int] = []
    columns: list[int] = []
    for i, end in enumerate(ends):
        near = order[i + 1 : end]
        near = near[np.abs(values[near] - values[order[i]]) <= tolerance]
        rows += [int(order[i])] * len(near)
        columns += near.tolist()
    graph = coo_array((np.ones(len(rows)), (rows, columns)), shape=(len(values), len(values)))
    count, labels = connected_components(graph, directed=False)
    return [np.flatnonzero(labels == label) for label in range(count)]


def _mode(triangle: Complex, basis: Complex, members: NDArray[np.intp], back: NDArray[np.float64]) -> Mode:
    """One cluster's mean eigenvalue, eigenvectors and participation."""
    k, n = len(members), len(triangle)
    t, q = _moved_to_front(triangle, basis, members)
    mean = complex(np.trace(t[:k, :k]) / k)
    rounding = _ROUNDING * float(np.linalg.norm(t))
    if abs(mean.imag) <= (rounding if k == 1 else CLUSTER * float(np.abs(np.diag(t)).max())):
        mean = complex(mean.real, 0.0)
    # T = [[T11, T12], [0, T22]]; with T11 X - X T22 = -T12 the projector is Q [[I, -X], [0, 0]] Q*
    coupling = solve_sylvester(t[:k, :k], -t[k:, k:], -t[:k, k:]) if k < n else np.zeros((k, 0), complex)
    right = q[:, :k]
    left = np.hstack([np.eye(k), -coupling]) @ q.conj().T
    share = np.abs(np.einsum("ij,ji->i", right, left))
    vectors = _eigenvectors(t[:k, :k] - mean * np.eye(k), right, back, rounding)
    return Mode(mean, k, vectors, share / share.sum())


def _moved_to_front(t: Complex, q: Complex, members: NDArray[np.intp]) -> tuple[Complex, Complex]:
    """The Schur form with the members first, by swapping neighbours with Givens rotations."""
    t, q = t.copy(), q.copy()
    for target, member in enumerate(members):
        for i in range(int(member) - 1, target - 1, -1):
            a, b, c = t[i, i], t[i, i + 1], t[i + 1, i + 1]
            x, y = b, c - a
            size = np.hypot(abs(x), abs(y))
            if size == 0:
                continue  # equal and uncoupled: nothing to swap
            g = np.array([[x, -np.conj(y)], [y, np.conj(x)]]) / size
            t[:, i : i + 2] = t[:, i : i + 2] @ g
            t[i : i + 2, :] = g.conj().T @ t[i : i + 2, :]
            q[:, i : i + 2] = q[:, i : i + 2] @ g
            t[i, i], t[i + 1, i + 1], t[i + 1, i] = c, a, 0
    return t, q


def _eigenvectors(shifted: Complex, right: Complex, back: NDArray[np.float64], rounding: float) -> Complex:
    """Independent eigenvectors: the null space of the cluster's own block, in the states' units."""
    k = len(shifted)
    if k == 1:
        vectors = right
    else:
        _, sizes, adjoint = np.linalg.svd(shifted)
        kept = np.flatnonzero(sizes <= max(rounding, 1e-6 * sizes[0]))
        kept = kept if len(kept) else np.array([k - 1])
        vectors = right @ adjoint.conj().T[:, kept]
    vectors = vectors * back[:, None]
    vectors = vectors / np.linalg.norm(vectors, axis=0)
    largest = np.take_along_axis(vectors, np.abs(vectors).argmax(axis=0)[None, :], axis=0)
    return vectors * (np.abs(largest) / largest)


def _condition(found: Sequence[Mode], back: NDArray[np.float64]) -> float:
    """Of all mode shapes in balanced coordinates, each of unit length."""
    if any(mode.is_defective for mode in found):
        return inf
    vectors = np.hstack([mode.shape for mode in found]) / back[:, None]
    return float(np.linalg.cond(vectors / np.linalg.norm(vectors, axis=0)))
