"""Eigenvalues of many variants of one model at once.

Variants differ in parameters and start values. The initial problem and the Jacobian of all of them are two
calls of mapped CasADi functions, their eigenvalues one of LAPACK's through NumPy; nothing is done for each
variant in Python, except for those whose relations differ from the first one's at the start, and for steady
states and instants of runs.
"""

from __future__ import annotations

from collections.abc import Generator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from acausal.analysis.linear import Matrix
from acausal.analysis.linearize import At, Setting, snapshots
from acausal.analysis.modes import UNCERTAINTY, Complex, Modes, modes
from acausal.analysis.snapshot import Snapshot
from acausal.analysis.starting import columns, mapped_start
from acausal.analysis.zeros import pivots_of, zeros_of
from acausal.codegen.functions import Code
from acausal.errors import AcausalError, UsageProblem, fail
from acausal.simulate.inputs import InputValue

_EXACT = 1e-11
_SHOWN = 6

Values = Sequence[float] | NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Variants:
    """Matrices (k, n, n) of k variants of a model with n states; `first` is the snapshot of the first one.

    `parameters` and `start` are what varies: k values by name.
    """

    first: Snapshot
    parameters: Mapping[str, tuple[float, ...]]
    start: Mapping[str, tuple[float, ...]]
    matrices: Matrix

    def __len__(self) -> int:
        return len(self.matrices)

    @property
    def states(self) -> tuple[str, ...]:
        return self.first.states

    @cached_property
    def eigenvalues(self) -> Complex:
        """(k, n) in 1/s, each variant's slowest first; those in a cluster have its mean, as in `modes`."""
        return self.decomposition.values

    @cached_property
    def decomposition(self) -> Decomposition:
        """Eigenvalues with their vectors, for following roots."""
        return decomposed(self.matrices, self.first.nominals)

    def modes(self, variant: int) -> Modes:
        """One variant's modes, with shapes and participation."""
        return modes(self.matrices[variant], self.first.nominals)

    def values_of(self, variant: int) -> dict[str, float]:
        """What one variant's parameters and start values are."""
        return {name: values[variant] for name, values in {**self.parameters, **self.start}.items()}


def variants(
    code: Code,
    parameters: Mapping[str, Values],
    at: At = "initial",
    *,
    start: Mapping[str, Values] | None = None,
    inputs: Mapping[str, InputValue] | None = None,
    rtol: float | None = None,
) -> Variants:
    """Every variant linearised; a single number is the same in all of them.

    Raises what `linearize` raises, and UsageProblem `variants.shape` for columns of different length.
    """
    given, starts, count = columns(parameters, start or {})
    first_setting = Setting(_row(given, 0), _row(starts, 0), inputs or {}, rtol)
    with _naming(given, starts, 0):
        (first,) = snapshots(code, [at], first_setting)
    matrices: Matrix | None = None
    if at == "initial":
        matrices = mapped_start(code, first, given, starts, inputs or {})
    settings = [Setting(_row(given, i), _row(starts, i), inputs or {}, rtol) for i in _left(matrices, count)]
    each = {} if not settings else dict(zip(_left(matrices, count), settings, strict=True))
    n = len(first.states)
    result = np.full((count, n, n), np.nan) if matrices is None else matrices
    for i, setting in each.items():
        with _naming(given, starts, i):
            snapshot = first if i == 0 else snapshots(code, [at], setting)[0]
        if snapshot.states != first.states:
            raise _other_states(first, i)
        result[i] = snapshot.a
    return Variants(first, given, starts, result)


@contextmanager
def _naming(
    given: Mapping[str, tuple[float, ...]], starts: Mapping[str, tuple[float, ...]], i: int
) -> Generator[None, None, None]:
    """Says which variant an error inside it is of, by the values that differ between variants."""
    try:
        yield
    except AcausalError as error:
        own = {name: values[i] for table in (given, starts) for name, values in table.items()}
        varied = {n for table in (given, starts) for n, values in table.items() if len(set(values)) > 1}
        texts = [f"{name} = {value:.9g}" for name, value in own.items() if name in varied]
        if not texts:
            raise
        first, *others = error.diagnostics
        message = f"{first.message} (variant {i + 1}: {', '.join(texts[:_SHOWN])})"
        names = tuple(dict.fromkeys([*first.names, *(name for name in own if name in varied)]))
        raise type(error)([replace(first, message=message, names=names), *others]) from error.__cause__


def _left(matrices: Matrix | None, count: int) -> list[int]:
    """The variants that have no matrix yet."""
    if matrices is None:
        return list(range(count))
    return np.flatnonzero(~np.isfinite(matrices).all(axis=(1, 2))).tolist()


def _row(table: Mapping[str, tuple[float, ...]], i: int) -> dict[str, float]:
    return {name: values[i] for name, values in table.items()}


def _other_states(first: Snapshot, i: int) -> Exception:
    return fail(
        UsageProblem,
        "variants.states",
        f"variant {i + 1} of {first.model} has other states there than the first one",
        hint="its states are chosen anew during a run: take each variant by itself",
    )


@dataclass(frozen=True, eq=False)
class Decomposition:
    """Eigenvalues (k, n) of k matrices; the others belong to what is left once the eigenvalue 0 is taken out.

    `inner` (k, i, i) are the matrices without it, `right` their vectors as columns, `left` as rows, so that
    `left @ right` is the identity. In a cluster the vectors are not to be relied upon.
    """

    values: Complex
    inner: Matrix
    right: Complex
    left: Complex


def decomposed(matrices: Matrix, nominals: NDArray[np.float64]) -> Decomposition:
    """All at once; where the first one has the eigenvalue 0, the others' null directions should be the same.

    Those for which they are not are looked at by themselves.
    """
    scaled = matrices * nominals / nominals[:, None]
    inner, odd = _without_zeros(scaled)
    values, right = np.linalg.eig(inner)
    values, right = values.astype(np.complex128), right.astype(np.complex128)
    order = np.lexsort((-values.imag, np.abs(values)), axis=-1)
    values = np.take_along_axis(values, order, axis=-1)
    right = np.take_along_axis(right, order[:, None, :], axis=-1)
    left = _inverse(right)
    sizes = np.linalg.norm(right, axis=1) * np.linalg.norm(left, axis=2)
    norms = np.linalg.norm(inner, axis=(1, 2))
    radii = UNCERTAINTY * norms[:, None] * np.minimum(sizes, 1 / np.finfo(float).eps)
    averaged, crowded = _averaged(values, radii)
    zeros = np.zeros((len(values), scaled.shape[1] - values.shape[1]), dtype=np.complex128)
    found = np.hstack([zeros, averaged])
    for i in dict.fromkeys([*odd, *crowded]):
        found[i] = modes(matrices[i], nominals).eigenvalues
    return Decomposition(found, inner, right, left)


def _without_zeros(scaled: Matrix) -> tuple[Matrix, list[int]]:
    """The matrices in coordinates relative to the first one's null directions, and those where that fails."""
    right = zeros_of(scaled[0]).right
    m = right.shape[1]
    if not m:
        return scaled, []
    pivots, rest = pivots_of(right)
    ratio = np.linalg.solve(right[pivots].T, right[rest].T).T
    inner = scaled[:, rest][:, :, rest] - ratio @ scaled[:, pivots][:, :, rest]
    moved = scaled @ right
    within = right.T @ moved
    sizes = np.maximum(np.abs(scaled).max(axis=2), 1e-300)
    off = np.abs(moved - right @ within).max(axis=2) / sizes
    is_wrong = (off > _EXACT).any(axis=1) | (
        np.abs(np.tril(within)).max(axis=(1, 2)) > _EXACT * sizes.max(axis=1)
    )
    return inner, np.flatnonzero(is_wrong).tolist()


def _inverse(right: Complex) -> Complex:
    """Of every matrix; the least squares one where a matrix is exactly singular."""
    try:
        return np.asarray(np.linalg.inv(right), dtype=np.complex128)
    except np.linalg.LinAlgError:
        return np.asarray(np.linalg.pinv(right, rcond=1e-15), dtype=np.complex128)


def _averaged(values: Complex, radii: Matrix) -> tuple[Complex, list[int]]:
    """The means of pairs that rounding cannot tell apart; and the variants with larger clusters."""
    near = np.abs(values[:, :, None] - values[:, None, :]) <= 2 * np.minimum(
        radii[:, :, None], radii[:, None, :]
    )
    some = np.flatnonzero(near.sum(axis=(1, 2)) > values.shape[1])
    if not some.size:
        return values, []
    linked = near[some].astype(np.float32)
    for _ in range(int(np.ceil(np.log2(values.shape[1] + 1)))):
        linked = (linked @ linked > 0).astype(np.float32)
    result = values.copy()
    weights = linked / linked.sum(axis=2, keepdims=True)
    result[some] = (weights.astype(np.float64) @ values[some][:, :, None])[:, :, 0]
    return result, some[linked.sum(axis=2).max(axis=1) > 2].tolist()
