"""The vocabulary of the graph algorithms: equation and variable indices, and who meets whom."""

from collections.abc import Sequence
from typing import NewType

Eq = NewType("Eq", int)
"""Index of an equation, counted from 0."""

Var = NewType("Var", int)
"""Index of a variable, counted from 0."""

Incidence = Sequence[Sequence[Var]]
"""Per equation the variables occurring in it, the preferred ones first."""


def equations(count: int) -> list[Eq]:
    """All equation indices below `count`, ascending."""
    return [Eq(i) for i in range(count)]


def variables(count: int) -> list[Var]:
    """All variable indices below `count`, ascending."""
    return [Var(i) for i in range(count)]


def check_incidence(incidence: Incidence, n_vars: int) -> None:
    """Prove that every variable named exists; raises ValueError with the first equation that errs. O(E)."""
    for eq, row in enumerate(incidence):
        if row and (min(row) < 0 or max(row) >= n_vars):
            raise ValueError(f"equation {eq} names a variable outside 0..{n_vars - 1}: {list(row)}")


def transpose(incidence: Incidence, n_vars: int) -> list[list[Eq]]:
    """Per variable the equations it occurs in, ascending, each once. O(E)."""
    columns: list[list[Eq]] = [[] for _ in range(n_vars)]
    for i, row in enumerate(incidence):
        eq = Eq(i)
        for var in row:
            column = columns[var]
            if not column or column[-1] != eq:
                column.append(eq)
    return columns
