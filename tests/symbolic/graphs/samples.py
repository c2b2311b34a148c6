"""Graphs to test with, and a clock that counts executed lines instead of seconds."""

import random
import sys
from collections.abc import Callable, Sequence
from types import FrameType
from typing import Any

from hypothesis import strategies as st

from acausal.symbolic.graphs.types import Var

Rows = list[list[Var]]


def rows_of(*rows: Sequence[int]) -> Rows:
    return [[Var(var) for var in row] for row in rows]


def random_rows(n_eqs: int, n_vars: int, mean_degree: float, seed: int) -> Rows:
    rng = random.Random(seed)
    degrees = [round(rng.expovariate(1 / mean_degree)) for _ in range(n_eqs)]
    picks = [[rng.randrange(n_vars) for _ in range(degree)] for degree in degrees]
    return [[Var(var) for var in dict.fromkeys(row)] for row in picks]


def random_loop(n: int, extra: int, seed: int) -> Rows:
    """A strongly connected square incidence: a ring plus `extra` further variables per equation."""
    rng = random.Random(seed)
    rows = [[i, (i + 1) % n, *(rng.randrange(n) for _ in range(extra))] for i in range(n)]
    return shuffled([[Var(var) for var in dict.fromkeys(row)] for row in rows], n, seed)


def shuffled(rows: Rows, n_vars: int, seed: int) -> Rows:
    """The same incidence with its equations, variables and lists in random order."""
    rng = random.Random(seed)
    names = list(range(n_vars))
    rng.shuffle(names)
    renamed = [[Var(names[var]) for var in row] for row in rows]
    for row in renamed:
        rng.shuffle(row)
    rng.shuffle(renamed)
    return renamed


def adverse_chain(n: int) -> Rows:
    """A chain whose first choices are all wrong: one augmenting path through everything."""
    return rows_of(*([i + 1, i] for i in range(n - 1)), [n - 1])


def adverse_chains(n: int, length: int) -> Rows:
    """`n` equations in adverse chains, each of another length around `length`."""
    rows: list[list[int]] = []
    size = length
    while len(rows) < n:
        start = len(rows)
        rows += [[start + i + 1, start + i] for i in range(size - 1)]
        rows.append([start + size - 1])
        size += 1
    return rows_of(*rows)


def grid(m: int) -> Rows:
    """The five-point stencil on m by m points."""
    near = ((0, 0), (-1, 0), (1, 0), (0, -1), (0, 1))
    points = [(i, j) for i in range(m) for j in range(m)]
    cells = [[(i + di, j + dj) for di, dj in near] for i, j in points]
    return rows_of(*([a * m + b for a, b in cell if 0 <= a < m and 0 <= b < m] for cell in cells))


def width(rows: Rows) -> int:
    """The number of variables of an incidence that uses its last one."""
    return 1 + max(max(row) for row in rows if row)


@st.composite
def incidences(draw: st.DrawFn, max_eqs: int = 7, max_vars: int = 7) -> tuple[Rows, int]:
    n_vars = draw(st.integers(0, max_vars))
    row = st.lists(st.integers(0, n_vars - 1), unique=True, max_size=4) if n_vars else st.just(list[int]())
    rows = draw(st.lists(row, max_size=max_eqs))
    return rows_of(*rows), n_vars


def lines_executed(run: Callable[[], object]) -> int:
    """How many lines of the graph package `run` executes: work without a clock's noise."""
    count = 0

    def on_line(_frame: FrameType, event: str, _arg: Any) -> Any:
        nonlocal count
        count += event == "line"
        return on_line

    def on_call(frame: FrameType, _event: str, _arg: Any) -> Any:
        return on_line if "symbolic/graphs" in frame.f_code.co_filename else None

    before = sys.gettrace()
    sys.settrace(on_call)
    try:
        run()
    finally:
        sys.settrace(before)
    return count
