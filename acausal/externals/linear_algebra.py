"""LAPACK routines by their names, as MSL's Math.Matrices.LAPACK calls them, evaluated by SciPy.

Arguments are LAPACK's, in order; a routine gives the new values of those it writes. Sizes are taken from the
arrays themselves.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import cast

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import lapack

from acausal.externals.arguments import (
    Argument,
    Changed,
    Routine,
    RoutineFailed,
    Tensor,
    matrix,
    number,
    tensor,
    text,
    wholes,
)

Array = NDArray[np.float64]
_Results = tuple[Array, ...]


def _lapack(name: str) -> Callable[..., _Results]:
    """SciPy's wrapper of a LAPACK routine."""
    return cast("Callable[..., _Results]", getattr(lapack, name))


def _integers(values: Array) -> Tensor:
    return Tensor(values.shape, tuple([int(v) for v in values.reshape(-1)]))


def _columns(value: Argument) -> Array:
    """A right-hand side as columns."""
    array = matrix(value)
    return array.reshape(-1, 1) if array.ndim == 1 else array


def _shape(value: Argument) -> tuple[int, ...]:
    return value.shape if isinstance(value, Tensor) else ()


def dgesv(args: Sequence[Argument]) -> Changed:
    """(n, nrhs, A, lda, ipiv, B, ldb, info): solve A X = B."""
    lu, pivots, x, info = _lapack("dgesv")(matrix(args[2]), _columns(args[5]))
    return {2: tensor(lu), 4: _integers(pivots + 1), 5: tensor(x, _shape(args[5])), 7: int(info)}


def dgetrf(args: Sequence[Argument]) -> Changed:
    """(m, n, A, lda, ipiv, info): LU factors."""
    lu, pivots, info = _lapack("dgetrf")(matrix(args[2]))
    return {2: tensor(lu), 4: _integers(pivots + 1), 5: int(info)}


def dgetrs(args: Sequence[Argument]) -> Changed:
    """(trans, n, nrhs, LU, lda, ipiv, B, ldb, info): solve with given LU factors."""
    transposed = 0 if text(args[0]).upper() == "N" else 1
    pivots = np.array(wholes(args[5])) - 1
    x, info = _lapack("dgetrs")(matrix(args[3]), pivots, _columns(args[6]), trans=transposed)
    return {6: tensor(x, _shape(args[6])), 8: int(info)}


def dgetri(args: Sequence[Argument]) -> Changed:
    """(n, LU, lda, ipiv, work, lwork, info): the inverse from LU factors."""
    inverse, info = _lapack("dgetri")(matrix(args[1]), np.array(wholes(args[3])) - 1)
    return {1: tensor(inverse), 6: int(info)}


def dgeev(args: Sequence[Argument]) -> Changed:
    """(jobvl, jobvr, n, A, lda, wr, wi, vl, ldvl, vr, ldvr, work, lwork, info): eigenvalues and vectors."""
    right = int(text(args[1]).upper() == "V")
    wr, wi, _, vr, info = _lapack("dgeev")(matrix(args[3]), compute_vl=0, compute_vr=right)
    changed: Changed = {5: tensor(wr), 6: tensor(wi), 13: int(info)}
    if right:
        changed[9] = tensor(vr)
    return changed


def dgesvd(args: Sequence[Argument]) -> Changed:
    """(jobu, jobvt, m, n, A, lda, s, U, ldu, VT, ldvt, work, lwork, info): singular values and vectors."""
    wanted = int(text(args[0]).upper() != "N")
    u, s, vt, info = _lapack("dgesvd")(matrix(args[4]), compute_uv=wanted, full_matrices=1)
    changed: Changed = {6: tensor(s), 13: int(info)}
    return changed | ({7: tensor(u), 9: tensor(vt)} if wanted else {})


def dgesdd(args: Sequence[Argument]) -> Changed:
    """(jobz, m, n, A, lda, s, U, ldu, VT, ldvt, work, lwork, iwork, info)."""
    wanted = int(text(args[0]).upper() != "N")
    u, s, vt, info = _lapack("dgesdd")(matrix(args[3]), compute_uv=wanted, full_matrices=1)
    changed: Changed = {5: tensor(s), 13: int(info)}
    return changed | ({6: tensor(u), 8: tensor(vt)} if wanted else {})


def dgels(args: Sequence[Argument]) -> Changed:
    """(trans, m, n, nrhs, A, lda, B, ldb, work, lwork, info): least squares with full rank."""
    factors, x, info = _lapack("dgels")(matrix(args[4]), _columns(args[6]))
    return {4: tensor(factors), 6: tensor(x, _shape(args[6])), 10: int(info)}


def dgelsy(args: Sequence[Argument]) -> Changed:
    """(m, n, nrhs, A, lda, B, ldb, jpvt, rcond, rank, work, lwork, info): least squares, any rank."""
    a, right = matrix(args[3]), _columns(args[5])
    tolerance = number(args[8])
    u, s, vt = np.linalg.svd(a, full_matrices=False)
    rank = int(np.sum(s > tolerance * s[0])) if s.size and s[0] > 0 else 0
    x = np.zeros_like(right)
    solution = vt[:rank].T @ ((u[:, :rank].T @ right[: a.shape[0]]) / s[:rank, None])
    x[: a.shape[1]] = solution
    return {5: tensor(x, _shape(args[5])), 9: rank, 12: 0}


def dgeqrf(args: Sequence[Argument]) -> Changed:
    """(m, n, A, lda, tau, work, lwork, info): QR factors."""
    qr, tau, _, info = _lapack("dgeqrf")(matrix(args[2]))
    return {2: tensor(qr), 4: tensor(tau), 7: int(info)}


def dgeqp3(args: Sequence[Argument]) -> Changed:
    """(m, n, A, lda, jpvt, tau, work, lwork, info): QR factors with column pivoting."""
    qr, pivots, tau, _, info = _lapack("dgeqp3")(matrix(args[2]))
    return {2: tensor(qr), 4: _integers(pivots), 5: tensor(tau), 8: int(info)}


def dorgqr(args: Sequence[Argument]) -> Changed:
    """(m, n, k, A, lda, tau, work, lwork, info): Q from its factors."""
    q, _, info = _lapack("dorgqr")(matrix(args[3]), np.array(matrix(args[5])))
    return {3: tensor(q), 8: int(info)}


def dpotrf(args: Sequence[Argument]) -> Changed:
    """(uplo, n, A, lda, info): Cholesky factor."""
    lower = int(text(args[0]).upper() == "L")
    factor, info = _lapack("dpotrf")(matrix(args[2]), lower=lower, clean=0)
    return {2: tensor(factor), 4: int(info)}


def dgecon(args: Sequence[Argument]) -> Changed:
    """(norm, n, LU, lda, anorm, rcond, work, iwork, info): reciprocal condition number."""
    norm = "I" if text(args[0]).upper() == "I" else "1"
    rcond, info = _lapack("dgecon")(matrix(args[2]), number(args[4]), norm=norm)
    return {5: float(rcond), 8: int(info)}


def dgtsv(args: Sequence[Argument]) -> Changed:
    """(n, nrhs, lower, diagonal, upper, B, ldb, info): tridiagonal systems."""
    lower, diagonal, upper, x, info = _lapack("dgtsv")(*[matrix(a) for a in args[2:5]], _columns(args[5]))
    return {
        2: tensor(lower),
        3: tensor(diagonal),
        4: tensor(upper),
        5: tensor(x, _shape(args[5])),
        7: int(info),
    }


def dlange(args: Sequence[Argument]) -> Changed:
    """(norm, m, n, A, lda, work): a norm of a matrix."""
    a, kind = np.abs(matrix(args[3])), text(args[0]).upper()
    if not a.size:
        return {-1: 0.0}
    norms = {"M": a.max(), "1": a.sum(axis=0).max(), "O": a.sum(axis=0).max(), "I": a.sum(axis=1).max()}
    norms |= dict.fromkeys("FE", float(np.sqrt((a * a).sum())))
    if kind not in norms:
        raise RoutineFailed(f"a matrix has no norm '{kind}'")
    return {-1: float(norms[kind])}


LINEAR_ALGEBRA: dict[str, Routine] = {
    routine.__name__: routine
    for routine in (
        dgesv, dgetrf, dgetrs, dgetri, dgeev, dgesvd, dgesdd, dgels, dgelsy, dgeqrf, dgeqp3, dorgqr, dpotrf,
        dgecon, dgtsv, dlange,
    )
}  # fmt: skip
