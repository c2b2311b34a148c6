"""What a snapshot says: its warnings, its JSON, and the words for a mode."""

from __future__ import annotations

from collections.abc import Sequence
from math import inf
from typing import TYPE_CHECKING

from acausal.analysis.modes import Mode, Modes
from acausal.simulate.messages import number
from acausal.simulate.stability import step_limits

if TYPE_CHECKING:
    from acausal.analysis.snapshot import Snapshot

_NAMED = 5


def warnings_of(snapshot: Snapshot) -> tuple[str, ...]:
    """Motion, growing modes, and events within a step, each in a sentence."""
    return (*_motion(snapshot), *_growth(snapshot), *_events(snapshot))


def _motion(snapshot: Snapshot) -> list[str]:
    moving = snapshot.moving
    if not moving:
        return []
    rates = dict(zip(snapshot.states, snapshot.residual.tolist(), strict=True))
    unit = dict(zip(snapshot.states, snapshot.units, strict=True))
    texts = [f"der({name}) = {number(rates[name])} {per_second(unit[name])}" for name in moving[:_NAMED]]
    more = f" and {len(moving) - _NAMED} more" if len(moving) > _NAMED else ""
    return [f"not at rest: {', '.join(texts)}{more}; the modes hold only while the states stay near"]


def _growth(snapshot: Snapshot) -> list[str]:
    found: list[str] = []
    for growth in snapshot.growing:
        mode = snapshot.modes.modes[growth.mode]
        what = f"the mode {value_text(mode.eigenvalue)} of {', '.join(growth.states)} {mode.kind}"
        found.append(f"{what}: {_reason(snapshot, growth.calmed_by)}")
    return found


def _reason(snapshot: Snapshot, calmed_by: Sequence[object]) -> str:
    named = [relation for relation in snapshot.relations if relation in calmed_by][:3]
    if not named:
        frozen = "no single frozen relation is the reason" if snapshot.relations else "no relation is frozen"
        rest = "the model is unstable here" if snapshot.is_equilibrium else "away from rest it need not last"
        return f"{frozen}; {rest}"
    texts = [f"`{r.text}` ({r.where}) as {str(r.holds).lower()}" for r in named]
    return f"frozen with {', '.join(texts)}; it would not grow the other way round"


def _events(snapshot: Snapshot) -> list[str]:
    near = snapshot.near_events
    texts = [f"`{r.text}` ({r.where}) in {number(r.seconds)} s" for r in near[:_NAMED]]
    more = f" and {len(near) - _NAMED} more" if len(near) > _NAMED else ""
    return [f"an event is within a step: {', '.join(texts)}{more}"] if near else []


def per_second(unit: str) -> str:
    """The unit of a derivative."""
    if not unit or unit == "1":
        return "1/s"
    return f"{unit}/s" if "/" not in unit else f"({unit})/s"


def value_text(value: complex) -> str:
    """An eigenvalue in 1/s: `-3.2`, or `-0.5 ± 12.4i` for a pair."""
    if value.imag == 0:
        return f"{value.real:.4g}"
    return f"{value.real:.4g} ± {abs(value.imag):.4g}i"


def when(snapshot: Snapshot) -> str:
    """`initial`, `0.5 s`, or `steady, 0.5 s`."""
    if snapshot.at == "initial":
        return "initial"
    return f"{'steady, ' if snapshot.at else ''}{snapshot.time:g} s"


def label(mode: Mode, states: Sequence[str]) -> str:
    """What a mode is and whose: `rigid body of a.phi, a.w`."""
    return f"{mode.kind}: {', '.join(mode.leading(states))}"


def snapshot_json(snapshot: Snapshot) -> dict[str, object]:
    """The keys of `acausal eigen --json`; what is infinite is null."""
    s = snapshot
    return {
        "model": s.model,
        "at": s.at or "instant",
        "time": s.time,
        "states": list(s.states),
        "units": dict(zip(s.states, s.units, strict=True)),
        "values": _by_state(s, s.values.tolist()),
        **modes_json(s.modes, s.states),
        "equilibrium": s.is_equilibrium,
        "residual": _by_state(s, s.residual.tolist()),
        "rates": _by_state(s, s.rates.tolist()),
        "relations": [relation.to_json() for relation in s.relations],
        "warnings": list(s.warnings),
    }


def modes_json(modes: Modes, states: Sequence[str]) -> dict[str, object]:
    """The keys `eigenvalues`, `max_step` and `condition`."""
    limits = step_limits(modes.eigenvalues).items()
    return {
        "eigenvalues": [
            _eigenvalue(mode, k, states) for mode in modes.modes for k in range(mode.multiplicity)
        ],
        "max_step": {method: None if limit == inf else limit for method, limit in limits},
        "condition": None if modes.condition == inf else modes.condition,
    }


def _by_state(snapshot: Snapshot, values: Sequence[object]) -> dict[str, object]:
    return dict(zip(snapshot.states, values, strict=True))


def _eigenvalue(mode: Mode, member: int, states: Sequence[str]) -> dict[str, object]:
    """One eigenvalue; all of a cluster have its mean, its participation and its shapes in turn."""
    column = mode.shape[:, min(member, mode.shape.shape[1] - 1)]
    constant = mode.time_constant
    return {
        "re": mode.eigenvalue.real,
        "im": mode.eigenvalue.imag,
        "frequency_hz": mode.frequency_hz,
        "damping_ratio": mode.damping_ratio,
        "time_constant": None if constant == inf else constant,
        "kind": mode.kind,
        "multiplicity": mode.multiplicity,
        "defective": mode.is_defective,
        "participation": dict(zip(states, mode.participation.tolist(), strict=True)),
        "shape": dict(zip(states, [[z.real, z.imag] for z in column.tolist()], strict=True)),
    }
