"""What eigenvalues of many variants cost beside NumPy's alone.

Timed: CPU time of one call for all variants, from parameters to eigenvalues, after one call that made the
functions; and of `numpy.linalg.eig` on the same matrices. Median of three.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from statistics import median
from time import process_time

import numpy as np

import acausal
from benchmarks.measure import Row

CHAIN = """model Chain "Masses on springs and dampers, one of the springs progressive"
  parameter Integer n = 15; parameter Boolean held = true;
  parameter Real c = 400, m = 0.5, d = 0.3, k3 = 5, s0 = 0.1;
  Real s[n](each start = s0, each fixed = true), v[n](each start = 0, each fixed = true), pull[n + 1];
equation
  pull[1] = if held then c*s[1] + k3*s[1]^3 else 0;
  for i in 2:n loop pull[i] = c*(s[i] - s[i - 1]) + d*(v[i] - v[i - 1]); end for;
  pull[n + 1] = 0;
  for i in 1:n loop der(s[i]) = v[i]; m*der(v[i]) = pull[i + 1] - pull[i]; end for;
end Chain;"""


def rows(*, quick: bool = False) -> Iterator[Row]:
    """One row for a chain that is held, one for a free one, whose rigid-body mode is taken out."""
    count = 200 if quick else 1000
    rng = np.random.default_rng(5)
    ranges = {"c": (300, 800), "m": (0.3, 1.5), "d": (0, 0.5), "s0": (0, 0.4)}
    table = {name: rng.uniform(low, high, count).tolist() for name, (low, high) in ranges.items()}
    for held in (True, False):
        compiled = acausal.loads(CHAIN).compile(held=held)
        matrices = compiled.variants(table).matrices

        def all_at_once() -> object:
            return compiled.variants(table).eigenvalues  # noqa: B023  # called before the next turn

        def numpy_alone() -> object:
            return np.linalg.eig(matrices)  # noqa: B023

        mine, numpys = _cpu(all_at_once), _cpu(numpy_alone)
        yield {
            "chain": "held" if held else "free",
            "states": matrices.shape[1],
            "variants": count,
            "us_per_variant": round(1e6 * mine / count, 1),
            "numpy_us": round(1e6 * numpys / count, 1),
            "ratio": round(mine / numpys, 2),
        }


def _cpu(work: Callable[[], object]) -> float:
    taken: list[float] = []
    for _ in range(3):
        began = process_time()
        work()
        taken.append(process_time() - began)
    return median(taken)
