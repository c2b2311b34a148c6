"""What run functions share and need not compute each time: what parameters decide, or they and the time.

Ramps of a schedule, masses and areas from parameters: at level 4 of the gearbox more than half of the
operations of the derivatives. `held` is computed once in a run, `timed` when the time is another one,
whichever function asks: a step evaluates most of them at its end. What the slopes alone need is separate, as
they are evaluated less often. The operations are those of the functions as they were, and so are the results.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import casadi as ca
from casadi import SX, Function

from acausal.codegen.casadi_expressions import FORWARD

WORTH = 0.15
"""The share of a function's operations that makes it worth while."""
FITTING = ("ode", "output", "jac", "derivative")
"""Zero crossings are looked at in more points than the others."""
_SLOPES = ("jac", "derivative")
STAGES = ("held", "timed", "timed_slopes")


@dataclass(frozen=True)
class Staged:
    """Functions by name, of which some take the results of `STAGES` as their last inputs."""

    functions: dict[str, Function]
    held: Function | None = None
    """`p -> held`; with it come functions `timed` and `timed_slopes`, `(t, p, held) -> ...`, if not empty."""


def staged(functions: Mapping[str, Function]) -> Staged:
    """Those of the functions that gain from it take what is computed before, the others stay."""
    fitting = {name: f for name, f in functions.items() if name in FITTING and f.is_a("SXFunction")}
    if not fitting:
        return Staged(dict(functions))
    inputs = {
        f.name_in(i): SX.sym(f.name_in(i), *f.size_in(i)) for f in fitting.values() for i in range(f.n_in())
    }
    p, t = inputs["p"], inputs["t"]
    results = {name: f.call([inputs[given] for given in f.name_in()]) for name, f in fitting.items()}
    rest, held, before = _extracted([part for parts in results.values() for part in parts], p, "held")
    rest, timed, values = _extracted(rest, ca.vertcat(t, p, held), "timed")
    later = iter(rest)
    results = {name: [next(later) for _ in parts] for name, parts in results.items()}
    often = {s.name() for name, parts in results.items() if name not in _SLOPES for s in _symbols(parts)}
    split = [
        [i for i in range(timed.shape[0]) if (timed[i].name() in often) is used] for used in (True, False)
    ]
    stages = [held, *(_of(timed, which) for which in split)]
    made = {
        name: _made(f, [inputs[given] for given in f.name_in()], results[name], stages)
        for name, f in fitting.items()
    }
    if not any("held" in f.name_in() for f in made.values()):
        return Staged(dict(functions))
    computed = [
        Function(name, [t, p, held], [_of(values, which)], ["t", "p", "held"], [name], FORWARD)
        for name, which in zip(STAGES[1:], split, strict=True)
    ]
    computed = {f.name(): f for f in computed if f.nnz_out(0)}
    return Staged(
        {**functions, **made, **computed}, Function("held", [p], [before], ["p"], ["held"], FORWARD)
    )


def _of(values: SX, which: list[int]) -> SX:
    return values[which] if which else SX(0, 1)


def _symbols(parts: Sequence[SX]) -> list[SX]:
    return ca.symvar(ca.vertcat(*[ca.densify(part).nz[:] for part in parts]))


def _extracted(results: list[SX], of: SX, name: str) -> tuple[list[SX], SX, SX]:
    """The results with new symbols for what depends on these inputs alone, the symbols, and their values."""
    found, symbols, values = ca.extract_parametric(results, of, {"prefix": f"{name}_"})
    return list(found), ca.vertcat(SX(0, 1), *symbols), ca.densify(ca.vertcat(SX(0, 1), *values))


def _made(f: Function, inputs: list[SX], results: list[SX], stages: list[SX]) -> Function:
    """The function that takes the stages; itself where that gains little."""
    names = [*f.name_in(), *STAGES]
    made = Function(f"{f.name()}_staged", [*inputs, *stages], results, names, f.name_out(), FORWARD)
    return made if f.n_instructions() - made.n_instructions() >= WORTH * f.n_instructions() else f
