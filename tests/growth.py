"""How work grows with the size of what it is done on: a ratio in one run, never seconds."""

from __future__ import annotations

from collections.abc import Callable
from time import process_time

Work = Callable[[], object]


def growth(prepare: Callable[[int], Work], small: int, large: int, repeats: int = 3) -> float:
    """CPU time per item at `large` over that at `small`; `prepare(size)` gives the work to be timed.

    The least of `repeats` is taken, because a loaded machine only ever makes it longer.
    """
    return _each(prepare, large, repeats) / _each(prepare, small, repeats)


def _each(prepare: Callable[[int], Work], size: int, repeats: int) -> float:
    taken: list[float] = []
    for _ in range(repeats):
        work = prepare(size)
        start = process_time()
        work()
        taken.append(process_time() - start)
    return min(taken) / size
