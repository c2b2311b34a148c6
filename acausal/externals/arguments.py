"""Arguments and results of the functions in the table: constants, and arrays of them row by row."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from acausal.symbolic.expressions.node import Constant, EnumValue

if TYPE_CHECKING:  # NumPy is loaded where arrays are computed with
    import numpy as np
    from numpy.typing import NDArray


@dataclass(frozen=True, slots=True)
class Tensor:
    """An array: its sizes, and its elements row by row."""

    shape: tuple[int, ...]
    items: tuple[Constant, ...]


Argument = Constant | Tensor
Changed = dict[int, Argument]
"""New values of the arguments that a function writes, by position; its result is at -1."""
Routine = Callable[[Sequence[Argument]], Changed]


class RoutineFailed(ValueError):
    """A function of the table cannot do what it is asked; a text for the message."""


def text(value: Argument) -> str:
    """A String argument."""
    if not isinstance(value, str):
        raise RoutineFailed(f"a String is needed, not {value!r}")
    return value


def whole(value: Argument) -> int:
    """An Integer or Boolean argument, or the number of an enumeration's literal."""
    if isinstance(value, EnumValue):
        return value.index
    if isinstance(value, (int, float)) and float(value).is_integer():
        return int(value)
    raise RoutineFailed(f"an Integer is needed, not {value!r}")


def number(value: Argument) -> float:
    """A Real argument."""
    if isinstance(value, (int, float)):
        return float(value)
    raise RoutineFailed(f"a number is needed, not {value!r}")


def numbers(value: Argument) -> list[float]:
    """The elements of an array argument."""
    items = value.items if isinstance(value, Tensor) else (value,)
    return [number(item) for item in items]


def wholes(value: Argument) -> list[int]:
    """The elements of an array of Integers."""
    items = value.items if isinstance(value, Tensor) else (value,)
    return [whole(item) for item in items]


def matrix(value: Argument) -> NDArray[np.float64]:
    """An array argument with its sizes."""
    import numpy as np

    shape = value.shape if isinstance(value, Tensor) else ()
    return np.array(numbers(value), dtype=float).reshape(shape)


def tensor(values: NDArray[np.float64], shape: tuple[int, ...] | None = None) -> Tensor:
    """An array as a result; `shape` where it differs from that of `values`."""
    return Tensor(shape or values.shape, tuple([float(v) for v in values.reshape(-1)]))
