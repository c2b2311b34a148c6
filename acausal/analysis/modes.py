"""The modes of dx/dt = A x: eigenvalues, mode shapes, participation of the states.

Eigenvalues that rounding cannot tell apart are one *cluster*. A cluster may be defective (a free body:
position and speed share the eigenvalue 0 and only one mode shape); its single eigenvalues are then
ill-conditioned, but their mean and the invariant subspace of the cluster are not. So every mode here is a
cluster, usually of one eigenvalue, and participation comes from the cluster's spectral projector.

What rounding cannot tell apart: eigenvalue i is known to r_i = K eps ||A|| / |y_i^H x_i| with its left and
right eigenvectors of unit length; i and j belong together if |lambda_i - lambda_j| <= 2 min(r_i, r_j). In a
Jordan block of order k both sides are of the size (eps ||A||)^(1/k), whatever k. The eigenvalue 0 is taken
out before, by ranks (`zeros`).

Source: G. H. Golub, C. F. Van Loan, Matrix Computations (2013), sections 7.2 and 7.6; for participation
I. J. Perez-Arriaga, G. C. Verghese, F. C. Schweppe, IEEE Trans. PAS 101 (1982), 3117-3125.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import inf, pi
from typing import cast

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import eig, matrix_balance, schur, solve_sylvester
from scipy.optimize import linear_sum_assignment
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from acausal.analysis.zeros import Zeros, complement, zeros_of

Matrix = NDArray[np.float64]
Complex = NDArray[np.complex128]

UNCERTAINTY = 100 * float(np.finfo(float).eps)
"""Backward error of an eigenvalue, relative to the norm of the matrix: K eps."""
_ROUNDING = 1e3 * float(np.finfo(float).eps)
"""Of a decomposition, relative to the norm of the matrix."""


@dataclass(frozen=True, eq=False)
class Mode:
    """A cluster of eigenvalues.

    `eigenvalue` is their mean, exactly 0 where the matrix is singular. `shape` has one column per
    independent eigenvector, of unit length, the largest entry real and positive. `participation` sums to one
    over the states. `uncertainty` is what rounding leaves open of the eigenvalue, in 1/s.
    """

    eigenvalue: complex
    multiplicity: int
    shape: Complex
    participation: NDArray[np.float64]
    uncertainty: float = 0.0

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

    @property
    def grows(self) -> bool:
        """Whether its solutions grow, beyond what rounding may have done."""
        return self.eigenvalue.real > self.uncertainty

    @property
    def kind(self) -> str:
        """What it is, in a word or two.

        `rigid body` is 0 with fewer shapes than eigenvalues: what is pushed moves on for ever. `free` is 0 as
        well, but stays where it is put: the common angle of what turns, an integrator. The others are
        `oscillates`, `decays`, `grows` and `grows oscillating`, with `defective` where shapes are missing.
        """
        if self.eigenvalue == 0:
            return "rigid body" if self.is_defective else "free"
        swings = self.eigenvalue.imag != 0
        word = ("grows oscillating" if swings else "grows") if self.grows else ""
        word = word or ("oscillates" if swings else "decays")
        return f"{word}, defective" if self.is_defective else word

    def leading(self, states: Sequence[str], most: int = 3, share: float = 0.05) -> tuple[str, ...]:
        """The states that take part most, the first first: at least one, no others below `share`.

        For a cluster `share` is of the largest, since all its modes share the sum.
        """
        least = share if self.multiplicity == 1 else 10 * share * float(self.participation.max())
        order: list[int] = np.argsort(-self.participation, kind="stable")[:most].tolist()
        return tuple(states[i] for k, i in enumerate(order) if k == 0 or self.participation[i] >= least)

    def others(self, shown: int, share: float = 0.05) -> int:
        """How many states take as much part as `leading` asks for, beyond those that were `shown`."""
        least = share if self.multiplicity == 1 else 10 * share * float(self.participation.max())
        return max(int((self.participation >= least).sum()) - shown, 0)


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


@dataclass(frozen=True, eq=False)
class _Decomposition:
    """The balanced matrix on the invariant subspace of all eigenvalues but 0, with vectors of unit length.

    A state is its balanced value times `back`. `frame` (n, k) spans the subspace, `inner` (k, k) is the
    matrix on it, `onto` (k, n) takes any vector there.
    """

    back: NDArray[np.float64]
    zeros: Zeros
    inner: Matrix
    frame: Matrix
    onto: Matrix
    values: Complex
    left: Complex
    right: Complex
    radii: NDArray[np.float64]
    norm: float


def modes(a: Matrix, scale: Sequence[float] | NDArray[np.float64] | None = None) -> Modes:
    """The modes of a real square matrix.

    `scale` are typical sizes of the states; with them, or with balancing where they are missing, units do
    not matter. O(n^3). Raises ValueError for a matrix that is not square or not finite.
    """
    if a.ndim != 2 or a.shape[0] != a.shape[1] or not np.isfinite(a).all():
        raise ValueError("the modes of a matrix need it to be square and finite")
    if not len(a):
        return Modes((), 1.0)
    sizes = np.ones(len(a)) if scale is None else np.asarray(scale, dtype=np.float64)
    parts = _decomposed(a, sizes)
    clusters = _clusters(parts)
    found = [_simple(parts, int(members[0])) for members in clusters if len(members) == 1]
    several = [members for members in clusters if len(members) > 1]
    if several:
        found += _several(parts, several)
    found.sort(key=lambda mode: abs(mode.eigenvalue))
    found = [*_zero(parts), *_with_conjugates(found, len(parts.values))]
    return Modes(tuple(found), _condition(found, parts.back))


def _decomposed(a: Matrix, sizes: NDArray[np.float64]) -> _Decomposition:
    found, (factors, _) = matrix_balance(a / sizes[:, None] * sizes, permute=False, separate=True)
    balanced = np.asarray(found, dtype=np.float64)
    zeros = zeros_of(balanced)
    frame, rows = complement(zeros.left)
    onto = np.eye(len(a))[rows] - zeros.right[rows] @ zeros.dual
    inner = balanced[rows] @ frame
    decomposition = cast("tuple[Complex, Complex, Complex]", eig(inner, left=True, right=True))
    values, left, right = (np.asarray(part, dtype=np.complex128) for part in decomposition)
    overlap = np.abs(np.einsum("ij,ij->j", left.conj(), right))
    norm = float(np.linalg.norm(inner))
    radii = UNCERTAINTY * norm / np.maximum(overlap, np.finfo(float).eps)
    return _Decomposition(sizes * factors, zeros, inner, frame, onto, values, left, right, radii, norm)


def _zero(parts: _Decomposition) -> list[Mode]:
    """The mode of the eigenvalue 0, if there is one."""
    zeros = parts.zeros
    if not zeros.multiplicity:
        return []
    vectors = zeros.right[:, : zeros.vectors].astype(np.complex128) * parts.back[:, None]
    return [Mode(0j, zeros.multiplicity, _normed(vectors), zeros.participation)]


def _with_conjugates(found: Sequence[Mode], n: int) -> list[Mode]:
    """Modes of a real matrix come in exactly conjugate pairs, the one with positive imaginary part first."""
    pairs: list[Mode] = []
    for mode in found:
        if mode.eigenvalue.imag >= 0:
            pairs.append(mode)
        if mode.eigenvalue.imag > 0:
            pairs.append(replace(mode, eigenvalue=mode.eigenvalue.conjugate(), shape=mode.shape.conj()))
    return pairs if sum(mode.multiplicity for mode in pairs) == n else list(found)


def _clusters(parts: _Decomposition) -> list[NDArray[np.intp]]:
    """Indices of eigenvalues that belong together: connected by steps that rounding may have made."""
    values, radii = parts.values, parts.radii
    distance = np.abs(values[:, None] - values[None, :])
    near = distance <= 2 * np.minimum(radii[:, None], radii[None, :])
    count, labels = connected_components(coo_array(near.astype(np.float64)), directed=False)
    return [np.flatnonzero(labels == label) for label in range(count)]


def _simple(parts: _Decomposition, i: int) -> Mode:
    """The mode of one eigenvalue that stands alone."""
    value = _real_if(complex(parts.values[i]), _ROUNDING * parts.norm)
    right, left = parts.frame @ parts.right[:, i], parts.left[:, i].conj() @ parts.onto
    share = np.abs(left * right)
    shape = _normed((right * parts.back)[:, None])
    return Mode(value, 1, shape, share / share.sum(), float(parts.radii[i]))


def _several(parts: _Decomposition, clusters: Sequence[NDArray[np.intp]]) -> list[Mode]:
    """The modes of eigenvalues that may belong together; what is too far apart for that is split."""
    triangle, basis = schur(parts.inner, output="complex")
    found: list[Mode] = []
    waiting = list(clusters)
    while waiting:
        members = waiting.pop()
        mode = _simple(parts, int(members[0])) if len(members) == 1 else None
        mode = mode or _cluster(parts, triangle, basis, members)
        if mode is not None:
            found.append(mode)
        else:
            waiting += _split(members, parts.values)
    return found


def _cluster(
    parts: _Decomposition, triangle: Complex, basis: Complex, members: NDArray[np.intp]
) -> Mode | None:
    """One cluster's mean eigenvalue, eigenvectors and participation.

    None if its eigenvalues lie further apart than a change of the matrix by rounding can take those of a
    Jordan block, (eps ||A||)^(1/k) ||T11||^(1 - 1/k).
    """
    k, n = len(members), len(triangle)
    chosen = _same(parts.values[members], np.diag(triangle))
    t, q = _moved_to_front(triangle, basis, chosen)
    # T = [[T11, T12], [0, T22]]; with T11 X - X T22 = -T12 the projector is Q [[I, -X], [0, 0]] Q*
    coupling = solve_sylvester(t[:k, :k], -t[k:, k:], -t[:k, k:]) if k < n else np.zeros((k, 0), complex)
    uncertainty = UNCERTAINTY * parts.norm * float(np.hypot(1.0, np.linalg.norm(coupling)))
    spread = float(np.abs(np.diag(t)[:k] - np.trace(t[:k, :k]) / k).max())
    size = float(np.linalg.norm(t[:k, :k]))
    if spread > 2 * uncertainty ** (1 / k) * size ** (1 - 1 / k):
        return None
    mean = _real_if(complex(np.trace(t[:k, :k]) / k), max(uncertainty, spread))
    right = q[:, :k]
    left = np.hstack([np.eye(k), -coupling]) @ q.conj().T
    share = np.abs(np.einsum("ij,ji->i", parts.frame @ right, left @ parts.onto))
    vectors = _eigenvectors(t[:k, :k] - mean * np.eye(k), right, _ROUNDING * parts.norm)
    shape = _normed((parts.frame @ vectors) * parts.back[:, None])
    return Mode(mean, k, shape, share / share.sum(), uncertainty)


def _split(members: NDArray[np.intp], values: Complex) -> list[NDArray[np.intp]]:
    """In two or more, at the widest gap."""
    distance = np.abs(values[members][:, None] - values[members][None, :])
    labels = np.arange(len(members))
    for reach in np.unique(distance)[::-1]:
        near = coo_array((distance < reach).astype(np.float64))
        count, labels = connected_components(near, directed=False)
        if count > 1:
            break
    return [members[labels == label] for label in range(int(labels.max()) + 1)]


def _real_if(value: complex, rounding: float) -> complex:
    """Without an imaginary part that rounding may have made."""
    return complex(value.real, 0.0) if abs(value.imag) <= rounding else value


def _same(values: Complex, diagonal: Complex) -> NDArray[np.intp]:
    """Where these eigenvalues stand on the diagonal of the Schur form, ascending."""
    rows, columns = linear_sum_assignment(np.abs(values[:, None] - diagonal[None, :]))
    return np.sort(columns[np.argsort(rows)])


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


def _eigenvectors(shifted: Complex, right: Complex, rounding: float) -> Complex:
    """Independent eigenvectors of a cluster: the null space of its own block."""
    _, sizes, adjoint = np.linalg.svd(shifted)
    kept = np.flatnonzero(sizes <= max(rounding, 1e-6 * sizes[0]))
    kept = kept if len(kept) else np.array([len(shifted) - 1])
    return right @ adjoint.conj().T[:, kept]


def _normed(vectors: Complex) -> Complex:
    """Columns of unit length, the largest entry of each real and positive."""
    vectors = vectors / np.linalg.norm(vectors, axis=0)
    largest = np.take_along_axis(vectors, np.abs(vectors).argmax(axis=0)[None, :], axis=0)
    return vectors * (np.abs(largest) / largest)


def _condition(found: Sequence[Mode], back: NDArray[np.float64]) -> float:
    """Of all mode shapes in balanced coordinates, each of unit length."""
    if any(mode.is_defective for mode in found):
        return inf
    vectors = np.hstack([mode.shape for mode in found]) / back[:, None]
    return float(np.linalg.cond(vectors / np.linalg.norm(vectors, axis=0)))
