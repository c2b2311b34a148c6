"""Solves small linear systems inside an expression graph: up to three unknowns by elimination, else by QR.

A single unknown `a z = b` may have `a = 0` in one mode (a closed valve: 0 z = 0). Systems of several unknowns
that a mode may make singular are solved by `solvers`.
"""

from __future__ import annotations

import casadi as ca
from casadi import SX

from acausal.codegen.casadi_expressions import jacobian

CANCELLED = 1e-13
"""A pivot this small beside the terms it is the difference of means a singular matrix."""


DEPENDENT = 1e-24
"""A column that loses so much of its square to the columns before it depends on them."""
CONSISTENT = 1e-6
"""`0 z = b` holds where `b` is this small beside the terms it consists of."""


def term_sizes(value: SX, u: SX) -> SX:
    """`sum_j |d value_i / d u_j| |u_j|`, the size of the terms of each value."""
    return ca.densify(ca.mtimes(ca.fabs(jacobian(value, u)), ca.fabs(u)))


def solve_switching(matrix: SX, right: SX, sizes: SX) -> SX:
    """`z = b / a`; 0, the solution of minimum norm, where `a` is 0 and so is `b`; else not-a-number."""
    singular = ca.if_else(ca.fabs(right) <= CONSISTENT * sizes, 0.0, float("nan"))
    pivot = ca.densify(matrix)
    return ca.if_else(pivot == 0, singular, right / pivot)


def solve_small(matrix: SX, right: SX) -> list[SX]:
    """The solution of `matrix z = right`; not-a-number where the matrix is singular.

    Gaussian elimination with row pivoting. Singular means that a pivot is the difference of numbers that
    agree to 13 digits, which does not depend on how the rows and columns are scaled.
    """
    n = int(right.shape[0])
    rows = [[matrix[i, j] for j in range(n)] for i in range(n)]
    sizes = [[ca.fabs(entry) for entry in row] for row in rows]
    rhs = [right[i] for i in range(n)]
    for k in range(n - 1):
        for i in range(k + 1, n):
            _swap_if_larger(rows, sizes, rhs, k, i)
        for i in range(k + 1, n):
            factor = rows[i][k] / rows[k][k]
            for j in range(k + 1, n):
                step = factor * rows[k][j]
                sizes[i][j] = sizes[i][j] + ca.fabs(step)
                rows[i][j] = rows[i][j] - step
            rhs[i] = rhs[i] - factor * rhs[k]
    return _back_substitute(rows, sizes, rhs)


def _swap_if_larger(rows: list[list[SX]], sizes: list[list[SX]], rhs: list[SX], k: int, i: int) -> None:
    """Exchanges rows `k` and `i` where the latter has the larger entry in column `k`."""
    if rows[i][k].is_zero():
        return
    larger = ca.fabs(rows[i][k]) > ca.fabs(rows[k][k])
    for table in (rows, sizes):
        above, below = table[k], table[i]
        table[k] = [ca.if_else(larger, b, a) for a, b in zip(above, below, strict=True)]
        table[i] = [ca.if_else(larger, a, b) for a, b in zip(above, below, strict=True)]
    rhs[k], rhs[i] = ca.if_else(larger, rhs[i], rhs[k]), ca.if_else(larger, rhs[k], rhs[i])


def _back_substitute(rows: list[list[SX]], sizes: list[list[SX]], rhs: list[SX]) -> list[SX]:
    n = len(rhs)
    solution: list[SX] = []
    for i in reversed(range(n)):
        known = [rows[i][j] * solution[n - 1 - j] for j in range(i + 1, n)]
        pivot = rows[i][i]
        total = rhs[i]
        for term in known:
            total = total - term
        value = total / pivot
        if i > 0:
            value = ca.if_else(ca.fabs(pivot) > CANCELLED * sizes[i][i], value, float("nan"))
        solution.append(value)
    return solution[::-1]


def solve_orthogonal(matrix: SX, right: SX) -> SX:
    """`z` with `matrix z = right`, column by column; not-a-number where the matrix is singular.

    Modified Gram and Schmidt on rows of size 1, which needs no pivoting (Bjorck, BIT 7, 1967), with entries
    that are zero left out. Singular means that 12 digits of a column are those of the columns before it.
    """
    n, width = right.shape
    scale = [1 / _total([ca.fabs(matrix[i, j]) for j in range(n)]) for i in range(n)]
    columns = [[scale[i] * matrix[i, j] for i in range(n)] for j in range(n)]
    rights = [[scale[i] * right[i, c] for i in range(n)] for c in range(width)]
    sizes = [_inner(column, column) for column in columns]
    upper: dict[tuple[int, int], SX] = {}
    found: list[list[SX]] = [[] for _ in rights]
    for k, column in enumerate(columns):
        square = _inner(column, column)
        inverse = ca.if_else(square > DEPENDENT * sizes[k], 1 / square, float("nan"))
        for j in range(k + 1, n):
            upper[k, j] = _removed(column, inverse, columns[j])
        for c, other in enumerate(rights):
            found[c].append(_removed(column, inverse, other))
    for values in found:
        for k in reversed(range(n)):
            values[k] = values[k] - _total([upper[k, j] * values[j] for j in range(k + 1, n)])
    return ca.sparsify(ca.horzcat(*[ca.vertcat(*values) for values in found]))


def _removed(column: list[SX], inverse: SX, other: list[SX]) -> SX:
    """Takes its part along `column` out of `other`; how much of it that is."""
    part = _inner(column, other) * inverse
    for i, entry in enumerate(column):
        other[i] = other[i] - part * entry
    return part


def _inner(a: list[SX], b: list[SX]) -> SX:
    return _total([x * y for x, y in zip(a, b, strict=True)])


def _total(terms: list[SX]) -> SX:
    total = SX(0)
    for term in terms:
        total = total + term
    return total
