"""How `acausal eigen` prints: tables of modes, of pairs of modes, of branches and variants."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import inf

import numpy as np

from acausal.analysis.batch import Variants
from acausal.analysis.compare import change, pairs
from acausal.analysis.modes import Mode
from acausal.analysis.snapshot import Snapshot
from acausal.analysis.sweep import Locus
from acausal.analysis.words import value_text, when
from acausal.cli.output import print_table, print_text
from acausal.simulate.stability import step_limits

_SHOWN = 40


def titles(found: Sequence[Snapshot]) -> list[str]:
    """Short names of snapshots: the model, unless it is the same for all, and the instant."""
    one_model = len({snapshot.model for snapshot in found}) == 1
    names = [when(snapshot) for snapshot in found]
    if one_model and len(found) > 1:
        return names
    return [f"{snapshot.model}, {name}" for snapshot, name in zip(found, names, strict=True)]


def title(snapshot: Snapshot) -> str:
    """`Model at its start`, `in its steady state` or `at 0.5 s`, and whether it rests."""
    steady = f"in its steady state at {snapshot.time:g} s"
    where = {"initial": "at its start", "steady": steady}.get(snapshot.at)
    states = f"{len(snapshot.states)} state{'s' if len(snapshot.states) != 1 else ''}"
    rest = "at rest" if snapshot.is_equilibrium else "not at rest"
    return f"{snapshot.model} {where or f'at {snapshot.time:g} s'}: {states}, {rest}"


def print_snapshot(snapshot: Snapshot, everything: bool) -> None:
    """The table of modes and the step limits."""
    print_text(f"{title(snapshot)}\n")
    rows = list(_rows(snapshot))
    shown = rows if everything else rows[:_SHOWN]
    heads = ("mode", "eigenvalue 1/s", "Hz", "damping", "time constant s", "times", "what", "of")
    print_table(shown, heads, right=range(6))
    if len(shown) < len(rows):
        print_text(f"and {len(rows) - len(shown)} faster ones; --all shows them")
    limits = [f"{name} {_step(limit)}" for name, limit in snapshot.max_step.items()]
    print_text(f"\nlongest stable step: {', '.join(limits)}")
    condition = "infinite (defective)" if snapshot.condition == inf else f"{snapshot.condition:.3g}"
    print_text(f"condition of the eigenvectors: {condition}")


def _three(damping: float) -> str:
    """Three digits, and no minus before nothing."""
    return f"{damping:.3f}".replace("-0.000", "0.000")


def _step(limit: float) -> str:
    return "any" if limit == inf else "none" if limit == 0 else f"{limit:.4g} s"


def _rows(snapshot: Snapshot) -> Iterator[Sequence[str]]:
    """One row for a mode or a conjugate pair, with the number that other options know it by."""
    for number, mode in enumerate(snapshot.modes.modes, 1):
        if mode.eigenvalue.imag < 0:
            continue
        constant = mode.time_constant
        leading = [snapshot.states.index(name) for name in mode.leading(snapshot.states)]
        yield (
            str(number),
            value_text(mode.eigenvalue),
            f"{mode.frequency_hz:.4g}",
            _three(mode.damping_ratio) if mode.eigenvalue else "-",
            "-" if constant == inf else f"{constant:.4g}",
            str(mode.multiplicity),
            mode.kind,
            _shares(snapshot, mode, leading),
        )


def _shares(snapshot: Snapshot, mode: Mode, leading: Sequence[int]) -> str:
    """`a.w 50%, a.phi 50%`, and how many more take part."""
    text = ", ".join(f"{snapshot.states[i]} {100 * mode.participation[i]:.0f}%" for i in leading)
    more = mode.others(len(leading)) if mode.multiplicity > 1 else 0
    return f"{text} and {more} more" if more else text


def print_comparison(one: Snapshot, other: Snapshot) -> None:
    """Matched modes of two models, side by side."""
    print_text(f"\ncompared with {title(other)}\n")
    rows = [_pair(one, other, pair.one, pair.other) for pair in pairs(one, other)]
    heads = ("mode", "other", "Hz", "other Hz", "change", "damping", "other", "of", "other's")
    print_table(rows, heads, right=range(7))


def _pair(one: Snapshot, other: Snapshot, a: int | None, b: int | None) -> Sequence[str]:
    first = one.modes.modes[a - 1] if a is not None else None
    second = other.modes.modes[b - 1] if b is not None else None
    moved = change(first, second)
    return (
        "-" if a is None else str(a),
        "-" if b is None else str(b),
        *(f"{m.frequency_hz:.4g}" if m is not None else "-" for m in (first, second)),
        "-" if moved is None else f"{100 * moved:+.1f}%",
        *(_three(m.damping_ratio) if m is not None else "-" for m in (first, second)),
        _states(first, one),
        _states(second, other),
    )


def _states(mode: Mode | None, snapshot: Snapshot) -> str:
    return "-" if mode is None else ", ".join(mode.leading(snapshot.states, 2))


def print_locus(locus: Locus, everything: bool) -> None:
    """Where every branch begins and ends, and its least damping on the way."""
    first = locus.variants.first
    unit = f" {locus.unit}" if locus.unit else ""
    print_text(
        f"{first.model}: {len(locus.values)} values of {locus.name} "
        f"from {locus.values[0]:g} to {locus.values[-1]:g}{unit}\n"
    )
    rows: list[Sequence[str]] = []
    for i, branch in enumerate(locus.roots.T):
        begin, end = complex(branch[0]), complex(branch[-1])
        if (begin.imag, end.imag) < (0.0, 0.0) or begin.imag < 0 or (begin.imag == 0 and end.imag < 0):
            continue
        sizes = np.abs(branch)
        damping = np.where(sizes > 0, -branch.real / np.where(sizes > 0, sizes, 1.0), 0.0)
        least = int(np.argmin(damping))
        hertz = [f"{abs(z) / (2 * np.pi):.4g}" for z in (begin, end)]
        at = f"{_three(float(damping[least]))} at {locus.values[least]:.4g}"
        rows.append((str(i + 1), value_text(begin), value_text(end), *hertz, at))
    shown = rows if everything else rows[:_SHOWN]
    heads = ("branch", "first 1/s", "last 1/s", "first Hz", "last Hz", "least damping")
    print_table(shown, heads, right=range(5))
    if len(shown) < len(rows):
        print_text(f"and {len(rows) - len(shown)} faster ones; --all shows them")
    if locus.branches.in_doubt:
        listed = ", ".join(f"{value:.6g}" for value in locus.branches.in_doubt[:8])
        print_text(f"\nbranches meet, and could not be told apart, before {locus.name} = {listed}")


def print_variants(found: Variants, everything: bool) -> None:
    """One line for each variant: what is least damped and fastest, and the longest steps."""
    print_text(f"{found.first.model}: {len(found)} variants of {len(found.states)} states\n")
    names = [*found.parameters, *found.start]
    rows: list[Sequence[str]] = []
    for i, roots in enumerate(found.eigenvalues[: None if everything else _SHOWN]):
        sizes = np.abs(roots)
        moving = roots[sizes > 0]
        worst = moving[np.argmin(-moving.real / np.abs(moving))] if moving.size else 0j
        damping = "-"
        if moving.size:
            damping = f"{_three(-worst.real / abs(worst))} at {abs(worst) / (2 * np.pi):.4g} Hz"
        limit = step_limits(roots)["heun"]
        values = [f"{value:.6g}" for value in found.values_of(i).values()]
        rows.append((str(i + 1), *values, damping, f"{sizes.max(initial=0.0):.4g}", _step(limit)))
    heads = ("variant", *names, "least damping", "largest 1/s", "step of heun")
    print_table(rows, heads, right=range(1 + len(names)))
    if len(rows) < len(found):
        print_text(f"and {len(found) - len(rows)} more; --all shows them")
