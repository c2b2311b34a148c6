"""The table of functions by name, and a kernel for those called while a simulation runs."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import islice
from math import prod

from acausal.externals.arguments import Argument, Changed, Routine, Tensor
from acausal.externals.random_numbers import RANDOM, impure_random
from acausal.externals.strings import STRINGS
from acausal.symbolic.expressions.kernel import Whole, digest
from acausal.symbolic.expressions.node import Constant

IMPURE_RANDOM = "ModelicaRandom_impureRandom_xorshift1024star"
_Shape = tuple[int, ...] | None
"""Sizes of an argument; None for a scalar."""


def find_routine(name: str) -> Routine | None:
    """A function of the table that depends on its arguments alone."""
    found = STRINGS.get(name) or RANDOM.get(name)
    if name == IMPURE_RANDOM:
        return impure_random
    if found is None and name.startswith("d"):
        from acausal.externals.linear_algebra import LINEAR_ALGEBRA  # late: it loads SciPy

        return LINEAR_ALGEBRA.get(name)
    if found is None and name.startswith("ModelicaFFT_"):
        from acausal.externals.fourier import FOURIER  # late: it loads NumPy

        return FOURIER.get(name)
    return found


@dataclass(frozen=True, eq=False)
class RoutineCall(Whole):
    """A call of a function of the table: all that it writes to the arguments `outputs` (position, size).

    `shapes` are the sizes of the function's arguments, `template` their elements; the call's own arguments
    stand where it has None.
    """

    name: str
    key: str
    shapes: tuple[_Shape, ...]
    template: tuple[Constant | None, ...]
    outputs: tuple[tuple[int, int], ...]

    @property
    def arity(self) -> int:  # pyright: ignore[reportIncompatibleVariableOverride]  # computed, never assigned
        return sum(value is None for value in self.template)

    @property
    def count(self) -> int:  # pyright: ignore[reportIncompatibleVariableOverride]  # as above
        return sum(size for _, size in self.outputs)

    def values(self, args: tuple[Constant, ...]) -> Sequence[Constant | None]:
        rest = iter(args)
        given = tuple([next(rest) if value is None else value for value in self.template])
        changed = _changed(self.name, self.shapes, given)
        found: list[Constant | None] = []
        for position, size in self.outputs:
            value = changed.get(position)
            found += value.items if isinstance(value, Tensor) else [value] * size
        return found


def routine_call(
    routine: str,
    shapes: Sequence[_Shape],
    template: tuple[Constant | None, ...],
    outputs: Sequence[tuple[int, int]],
) -> RoutineCall:
    """The call with `outputs`, by their position among the arguments and with their numbers of elements."""
    key = digest(routine, tuple(shapes), template, tuple(outputs))
    return RoutineCall(routine, key, tuple(shapes), template, tuple(outputs))


@lru_cache(maxsize=256)
def _changed(routine: str, shapes: tuple[_Shape, ...], args: tuple[Constant, ...]) -> Changed:
    """All results of one call, for the kernels that share it."""
    run = find_routine(routine)
    assert run is not None  # whoever made the kernel has looked
    rest = iter(args)
    values: list[Argument] = [
        next(rest) if shape is None else Tensor(shape, tuple(islice(rest, prod(shape)))) for shape in shapes
    ]
    return run(values)
