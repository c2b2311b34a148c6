"""Differential-algebraic systems written as signatures: the structure their papers print, and random ones."""

import random
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from acausal.symbolic.graphs.pantelides import Reduction, pantelides
from acausal.symbolic.graphs.types import Eq, Var
from tests.symbolic.graphs.samples import Rows

Signature = Sequence[Mapping[str, Sequence[int]]]
"""Per equation, for each quantity in it, the orders of its derivatives that occur."""


@dataclass(frozen=True)
class System:
    """Arguments of `pantelides`, with the name of each variable: `x` and primes for its derivatives."""

    rows: Rows
    names: list[str]
    derivative_of: list[Var | None]

    @property
    def n_vars(self) -> int:
        return len(self.names)

    def reduce(self) -> Reduction:
        return pantelides(self.rows, self.n_vars, self.derivative_of)


def system(signature: Signature) -> System:
    """Number the variables: all quantities first, then their first derivatives, and so on."""
    order: dict[str, int] = {}
    for equation in signature:
        for name, orders in equation.items():
            order[name] = max(order.get(name, 0), *orders)
    index: dict[tuple[str, int], Var] = {}
    for k in range(max(order.values()) + 1):
        for name, highest in order.items():
            if k <= highest:
                index[name, k] = Var(len(index))
    rows = [[index[name, k] for name, orders in equation.items() for k in orders] for equation in signature]
    return System(
        rows, [name + "'" * k for name, k in index], [index.get((name, k + 1)) for name, k in index]
    )


def all_names(sample: System, reduction: Reduction) -> list[str]:
    """The names of all variables, appended derivatives included."""
    names = sample.names + [""] * (reduction.n_vars - sample.n_vars)
    pending = [Var(i) for i in range(sample.n_vars)]
    while pending:
        low = pending.pop()
        high = reduction.derivative_of[low]
        if high is not None and names[high] == "":
            names[high] = names[low] + "'"
            pending.append(high)
    return names


def derivative_chain(reduction: Reduction, eq: Eq) -> list[Eq]:
    """An equation and all its derivatives, lowest first."""
    chain = [eq]
    while (higher := reduction.equation_derivative[chain[-1]]) is not None:
        chain.append(higher)
    return chain


def random_signature(n: int, extra: float, order: int, seed: int) -> list[dict[str, list[int]]]:
    """A solvable system: equation i contains quantity p(i), and a few others, in random orders."""
    rng = random.Random(seed)
    names = [f"v{i}" for i in range(n)]
    rng.shuffle(names)
    signature: list[dict[str, list[int]]] = []
    for i in range(n):
        others = [rng.choice(names) for _ in range(round(rng.expovariate(1 / extra)))]
        signature.append({name: [rng.randint(0, order)] for name in (names[i], *others)})
    return signature


PENDULUM = system(
    [{"x": [2], "T": [0]}, {"x": [0], "y": [0]}, {"y": [2], "T": [0], "x": [0]}],
)
"""x'' = -T x, x^2 + y^2 = 1, y'' = -T y - g; here with the constraint in the middle."""

PENDULUM_FIRST_ORDER = system(
    [
        {"x": [1], "w": [0]},
        {"y": [1], "z": [0]},
        {"w": [1], "T": [0], "x": [0]},
        {"z": [1], "T": [0], "y": [0]},
        {"x": [0], "y": [0]},
    ]
)
"""The pendulum of Pantelides 1988: x' = w, y' = z, w' = T x, z' = T y - g, x^2 + y^2 = L^2."""

REACTOR = system(
    [
        {"C": [0, 1], "R": [0]},
        {"T": [0, 1], "R": [0], "Tc": [0]},
        {"R": [0], "T": [0], "C": [0]},
        {"C": [0]},
    ]
)
"""The exothermic reactor of Pantelides 1988 with its concentration prescribed:
C' = K1 (C0 - C) - R, T' = K1 (T0 - T) + K2 R - K3 (T - Tc), R = K3 exp(-K4/T) C, C = u(t)."""

HIDDEN = system([{"x": [1], "y": [1]}, {"x": [0], "y": [0]}])
"""x' + y' = a(t), x + y^2 = b(t): the constraint hides x' + 2 y y' = b'(t)."""

LINEAR = system(
    [
        {"x1": [0], "x2": [0]},
        {"x1": [0], "x2": [0], "x3": [0]},
        {"x1": [0], "x3": [1], "x4": [0]},
        {"x1": [2], "x2": [2], "x3": [2], "x4": [1]},
    ]
)
"""The linear system of Mattsson and Soederlind 1993: x1 + x2 + u1 = 0, x1 + x2 + x3 + u2 = 0,
x1 + x3' + x4 + u3 = 0, 2 x1'' + x2'' + x3'' + x4' + u4 = 0."""

INTEGRATORS = system([{"x": [0]}, {"x": [1], "y": [0]}, {"y": [1], "z": [0]}])
"""x = f(t), x' = y, y' = z: everything is given by derivatives of f."""


def cells(count: int, linked: bool = False) -> System:
    """`count` bodies x' = v, v' = F with x = u(t); linked ones also see their neighbour's x."""
    signature: list[dict[str, list[int]]] = []
    for i in range(count):
        neighbour: dict[str, list[int]] = {f"x{i - 1}": [0]} if linked and i else {}
        body: list[dict[str, list[int]]] = [
            {f"x{i}": [1], f"v{i}": [0]},
            {f"v{i}": [1], f"F{i}": [0]},
            {f"x{i}": [0], **neighbour},
        ]
        signature += body
    return system(signature)
