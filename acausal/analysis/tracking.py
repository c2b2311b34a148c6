"""Following roots over a parameter: which eigenvalue of one variant is which of the next.

First order perturbation predicts where eigenvalue i goes, lambda_i + y_i^H (A' - A) x_i with y_i^H x_i = 1;
predictions and eigenvalues are then paired at least total distance (the assignment problem). Where a pairing
is in doubt, because the step is large beside the distance to another root, the step is halved.

Source: G. H. Golub, C. F. Van Loan, Matrix Computations (2013), section 7.2.2; R. Jonker, A. Volgenant,
Computing 38 (1987), 325-340, as in SciPy.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import inf

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linear_sum_assignment

from acausal.analysis.batch import Decomposition
from acausal.analysis.modes import Complex

MAX_HALVINGS = 6
_DOUBT = 0.25
"""Of the distance to the next root: as far as a root may be from where it was predicted."""
_SAME = 1e-6
"""Roots this close, relative to the largest, cannot be told apart and need not be."""
_TRUSTED = 1e6
"""Condition of an eigenvalue up to which its prediction counts."""

Solve = Callable[[Sequence[float]], Decomposition]
"""Decompositions at values of the parameter."""


@dataclass(frozen=True, eq=False)
class Branches:
    """Roots followed over `values`: `roots` (k, n), one column for each branch.

    `position` (k, n) says where each stands among the eigenvalues of its variant; `in_doubt` are the values
    before which branches could not be told apart.
    """

    values: tuple[float, ...]
    roots: Complex
    position: NDArray[np.intp]
    in_doubt: tuple[float, ...]


@dataclass(frozen=True, eq=False)
class _Node:
    """The eigenvalues at one value of the parameter, and what predicts the next ones."""

    value: float
    roots: Complex
    parts: Decomposition
    row: int


def follow(values: Sequence[float], solve: Solve) -> Branches:
    """The branches at these values; in between, more are looked at where roots come close."""
    nodes = _nodes(values, solve(values))
    order = np.arange(len(nodes[0].roots))
    positions, doubts = [order], list[float]()
    for before, after in pairwise(nodes):
        step, sure = _paired(before, after, solve, MAX_HALVINGS)
        order = step[order]
        positions.append(order)
        if not sure:
            doubts.append(after.value)
    position = np.array(positions, dtype=np.intp)
    roots = np.array([node.roots[p] for node, p in zip(nodes, positions, strict=True)])
    return Branches(tuple(values), roots, position, tuple(doubts))


def _nodes(values: Sequence[float], parts: Decomposition) -> list[_Node]:
    return [_Node(value, parts.values[i], parts, i) for i, value in enumerate(values)]


def _paired(before: _Node, after: _Node, solve: Solve, halvings: int) -> tuple[NDArray[np.intp], bool]:
    """For each root before, its place after; and whether that is beyond doubt."""
    found, sure = _assigned(before, after)
    if sure or not halvings:
        return found, sure
    (middle,) = _nodes([(before.value + after.value) / 2], solve([(before.value + after.value) / 2]))
    first, first_sure = _paired(before, middle, solve, halvings - 1)
    second, second_sure = _paired(middle, after, solve, halvings - 1)
    return second[first], first_sure and second_sure


def _assigned(before: _Node, after: _Node) -> tuple[NDArray[np.intp], bool]:
    expected = _predicted(before, after)
    distance = np.abs(expected[:, None] - after.roots[None, :])
    _, places = linear_sum_assignment(distance)
    places = np.asarray(places, dtype=np.intp)
    error = distance[np.arange(len(places)), places]
    found = after.roots[places]
    apart = np.abs(found[:, None] - found[None, :])
    tolerance = _SAME * max(float(np.abs(after.roots).max(initial=0.0)), 1e-300)
    apart = np.where(apart <= tolerance, inf, apart)
    return places, bool((error <= _DOUBT * apart.min(axis=1, initial=inf)).all())


def _predicted(before: _Node, after: _Node) -> Complex:
    """Where the roots before are expected after; where that cannot be known, where they were."""
    one, other = before.parts, after.parts
    zeros = len(before.roots) - one.inner.shape[-1]
    if one.inner.shape[1:] != other.inner.shape[1:]:
        return before.roots
    left, right = one.left[before.row], one.right[before.row]
    change = other.inner[after.row] - one.inner[before.row]
    shift = np.einsum("ij,jk,ki->i", left, change, right)
    size = np.linalg.norm(left, axis=1) * np.linalg.norm(right, axis=0)
    trusted = (size < _TRUSTED) & np.isfinite(shift) & (np.abs(shift) < 0.5 * np.abs(before.roots[zeros:]))
    result = before.roots.copy()
    result[zeros:] += np.where(trusted, shift, 0.0)
    return result
