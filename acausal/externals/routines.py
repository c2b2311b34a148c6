"""The table of functions by name, and a kernel for those that are called while a simulation runs."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import islice
from math import prod

from acausal.externals.arguments import Argument, Changed, Routine, Tensor
from acausal.externals.random_numbers import RANDOM, impure_random
from acausal.externals.strings import STRINGS
from acausal.symbolic.expressions.kernel import Kernel, digest
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
class Called(Kernel):
    """One scalar that a function of the table computes: element `element` of what it puts at `position`.

    `shapes` are the sizes of the function's arguments, `template` their elements; the kernel's own arguments
    stand where it has None.
    """

    name: str
    routine: str
    shapes: tuple[_Shape, ...]
    template: tuple[Constant | None, ...]
    position: int
    element: int
    result: str
    key: str
    arity: int
    continuity: int = -1

    @property
    def is_discrete(self) -> bool:
        return True

    def evaluate(self, *args: Constant) -> Constant:
        rest = iter(args)
        given = tuple([next(rest) if value is None else value for value in self.template])
        value = _changed(self.routine, self.shapes, given).get(self.position)
        if value is None:
            raise ValueError(f"{self.routine} fails")
        single = value.items[self.element] if isinstance(value, Tensor) else value
        return round(single) if self.result == "Integer" and isinstance(single, float) else single

    def partial(self, argument: int) -> Kernel | None:
        return None


def caller(
    routine: str,
    shapes: Sequence[_Shape],
    template: tuple[Constant | None, ...],
    position: int,
    result: str,
    name: str,
) -> Callable[[int], Called]:
    """Makes the kernels of one call's result, element by element."""
    base = digest(name, routine, tuple(shapes), template, position, result)
    arity = sum(value is None for value in template)

    def called(element: int) -> Called:
        key = f"{base}:{element}"
        return Called(name, routine, tuple(shapes), template, position, element, result, key, arity)

    return called


@lru_cache(maxsize=4096)
def _changed(routine: str, shapes: tuple[_Shape, ...], args: tuple[Constant, ...]) -> Changed:
    """All results of one call, for the kernels that share it."""
    run = find_routine(routine)
    assert run is not None  # whoever made the kernel has looked
    rest = iter(args)
    values: list[Argument] = [
        next(rest) if shape is None else Tensor(shape, tuple(islice(rest, prod(shape)))) for shape in shapes
    ]
    return run(values)
