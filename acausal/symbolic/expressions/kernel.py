"""Kernels: functions that a call keeps as a unit instead of being inlined, such as tables.

`expr.call(kernel, *args)` is the call. A kernel is a value: two with the same `key` (a digest of what they
hold) are the same, so hash-consing merges equal calls. It evaluates numerically here; what it looks like in
CasADi is `acausal.codegen.kernels`' business.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from hashlib import sha256

from acausal.symbolic.expressions.node import Constant, EnumValue


class NoDerivative(Exception):
    """A function of which only values are known (an external object, a function as an argument)."""


class Kernel(ABC):
    """A function of scalars with one scalar result. Subclasses are immutable and implement `evaluate`."""

    __slots__ = ()
    name: str
    """As printed; not unique."""
    key: str
    """Digest of the contents: what makes two kernels the same."""
    arity: int
    result: str
    """The result's type: `Real`, `Integer`, `Boolean`, `String`."""
    continuity: int
    """-1: jumps; 0: continuous with kinks; n: n times continuously differentiable."""

    @abstractmethod
    def evaluate(self, *args: Constant) -> Constant:
        """The value; raises ArithmeticError or ValueError where there is none."""

    def partial(self, argument: int) -> Kernel | None:
        """The derivative with respect to an argument (from 0), of the same arguments; None: it is zero.

        Raises `NoDerivative` where there is none.
        """
        raise NoDerivative(self.name)

    def moves_with(self, argument: int) -> bool:
        """Whether the value may change with an argument in a way that the pieces do not account for."""
        return True

    @property
    def is_discrete(self) -> bool:
        """Whether it makes sense at events only and has no derivatives (random numbers, texts)."""
        return False

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Kernel) and self.key == other.key

    def __hash__(self) -> int:
        return hash(self.key)


class Whole(ABC):
    """A function with many scalar results that are computed together, at events; `Part` is one of them.

    The calls of its parts share their arguments (`expr.calls`), and code evaluates it once for all of them.
    """

    __slots__ = ()
    name: str
    """As printed; not unique."""
    key: str
    """Digest of the contents: what makes two of them the same."""
    arity: int
    count: int
    """The number of results."""

    @abstractmethod
    def values(self, args: tuple[Constant, ...]) -> Sequence[Constant | None]:
        """All results, None where there is none; raises ArithmeticError or ValueError where all fail."""


@dataclass(frozen=True, eq=False)
class Part(Kernel):
    """Result `index` of a function that is evaluated at events only."""

    whole: Whole
    index: int
    name: str
    result: str
    continuity: int = -1

    @property
    def key(self) -> str:  # pyright: ignore[reportIncompatibleVariableOverride]  # computed, never assigned
        return f"{self.whole.key}:{self.index}"

    @property
    def arity(self) -> int:  # pyright: ignore[reportIncompatibleVariableOverride]  # as above
        return self.whole.arity

    @property
    def is_discrete(self) -> bool:
        return True

    def evaluate(self, *args: Constant) -> Constant:
        value = self.whole.values(args)[self.index]
        if value is None:
            raise ValueError(f"{self.name} has no value")
        if isinstance(value, EnumValue):
            return value.index
        return round(value) if self.result == "Integer" and isinstance(value, float) else value

    def partial(self, argument: int) -> Kernel | None:
        return None


@dataclass(frozen=True, eq=False)
class Guarded(Whole):
    """`inner` where its first argument is true; zeros, which nobody reads, where it is not."""

    inner: Whole

    @property
    def name(self) -> str:  # pyright: ignore[reportIncompatibleVariableOverride]  # computed, never assigned
        return self.inner.name

    @property
    def key(self) -> str:  # pyright: ignore[reportIncompatibleVariableOverride]  # as above
        return f"{self.inner.key} if"

    @property
    def arity(self) -> int:  # pyright: ignore[reportIncompatibleVariableOverride]  # as above
        return self.inner.arity + 1

    @property
    def count(self) -> int:  # pyright: ignore[reportIncompatibleVariableOverride]  # as above
        return self.inner.count

    def values(self, args: tuple[Constant, ...]) -> Sequence[Constant | None]:
        return self.inner.values(args[1:]) if args[0] else (0.0,) * self.count


@dataclass(frozen=True, eq=False)
class Named(Kernel):
    """A function of which only the name is known: it prints, and nothing else."""

    name: str
    arity: int
    result: str = "Real"
    continuity: int = -1

    @property
    def key(self) -> str:  # pyright: ignore[reportIncompatibleVariableOverride]  # computed, never assigned
        return f"{self.name}/{self.arity}"

    def evaluate(self, *args: Constant) -> Constant:
        raise ValueError(f"{self.name} has no value")


def digest(*parts: object) -> str:
    """A key of a kernel from what it holds: numbers, texts and tuples of them."""
    return sha256(repr(parts).encode()).hexdigest()[:24]
