"""Which nonlinear block is about to lose its solution: at a fold its Jacobian becomes singular."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from acausal.codegen.program import ExplicitCode, ImplicitCode
from acausal.simulate.call import call, residual_and_jacobian
from acausal.simulate.evaluator import Evaluator
from acausal.simulate.matrices import Vector, is_finite, row_sums, scaled
from acausal.symbolic.causal import Block, BlockKind

NEAR = 1e-2
"""A block is close to singular where its smallest singular value is below this."""
_MOST = 200


def ending_block(evaluator: Evaluator) -> Block | None:
    """The nonlinear block that is closest to singular at the evaluator's point and guesses, if one is."""
    if not evaluator.guess.size:
        return None
    with np.errstate(all="ignore"):
        found = [(share, i, block) for i, (share, block) in enumerate(_regularities(evaluator))]
    share, _, block = min(found, default=(1.0, 0, None), key=lambda item: item[:2])
    return block if share < NEAR else None


def _regularities(evaluator: Evaluator) -> Iterator[tuple[float, Block]]:
    """Of every nonlinear block the smallest singular value, rows in units of all terms' sizes."""
    program = evaluator.code.dynamic
    slots, nominals = program.slots, evaluator.nominal_of()
    guess = dict(zip(program.guesses, evaluator.guess.tolist(), strict=True))
    e = evaluator
    values = np.full(len(slots), np.nan)
    inputs = np.concatenate([e.t, e.x, e.p, e.m, e.u, e.d])
    values[: len(inputs)] = inputs
    for code in program.codes:
        known = values[[slots[leaf] for leaf in code.reads]]
        targets = [slots[leaf] for leaf in code.writes]
        if isinstance(code, ExplicitCode):
            values[targets] = call(code.run, known)[0].ravel()
            continue
        tearing = code.block.tearing
        z = np.array([guess[leaf] for leaf in tearing])
        values[targets] = np.concatenate([z, call(code.rest, z, known)[0].ravel()])
        if code.block.kind is BlockKind.NONLINEAR and len(z) <= _MOST:
            yield (
                _regularity(code, z, known, np.array([nominals.get(leaf, 1.0) for leaf in tearing])),
                code.block,
            )


def _regularity(code: ImplicitCode, z: Vector, known: Vector, nominal: Vector) -> float:
    """Between 0 (singular) and 1; 1 where something is not a number."""
    jacobian = residual_and_jacobian(code.residual, z, known)[1]
    columns = np.maximum(np.abs(z), nominal)
    rows = row_sums(jacobian, columns) + call(code.terms, z, known)[0].ravel()
    if not (is_finite(jacobian) and np.isfinite(rows).all()) or not (rows > 0).all():
        return 1.0
    matrix = scaled(jacobian, rows, columns)
    dense = matrix if isinstance(matrix, np.ndarray) else np.asarray(matrix.toarray(), dtype=np.float64)
    return float(np.linalg.svd(dense, compute_uv=False)[-1])
