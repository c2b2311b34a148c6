"""Snapshots as HTML: a page to point at, and what notebooks show. Nothing is loaded from elsewhere."""

from __future__ import annotations

import json
from base64 import b64encode
from collections.abc import Iterator, Sequence
from html import escape
from importlib.resources import files
from math import inf
from typing import TYPE_CHECKING

import numpy as np

from acausal.analysis.modes import Mode
from acausal.analysis.words import value_text, when

if TYPE_CHECKING:
    from acausal.analysis.snapshot import Snapshot

_SHARE, _AMPLITUDE = 1e-3, 1e-2
_ROWS = 40
_HEAD = ("mode", "eigenvalue [1/s]", "frequency [Hz]", "damping", "time constant [s]", "times", "what", "of")


def page(
    title: str,
    snapshots: Sequence[Snapshot],
    names: Sequence[str],
    tracks: Sequence[Sequence[tuple[float, float]]] = (),
    chosen: int | None = None,
) -> str:
    """An interactive page: the complex plane to zoom into, the shape of the mode one points at, tables.

    `tracks` are lines of (real, imaginary) parts that are drawn as well; `chosen` is the number of the mode
    that is shown first.
    """
    data = {
        "snapshots": [_data(snapshot, name) for snapshot, name in zip(snapshots, names, strict=True)],
        "tracks": tracks,
        "chosen": chosen,
    }
    text = json.dumps(data, allow_nan=False, separators=(",", ":")).replace("<", "\\u003c")
    keys = "".join(
        f'<label data-key="{i}"><input type="checkbox" data-show="{i}" checked> {escape(name)} </label>'
        for i, name in enumerate(names)
    )
    tables = "\n".join(_section(i, s, n) for i, (s, n) in enumerate(zip(snapshots, names, strict=True)))
    return (
        '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f"<title>{escape(title)}</title>\n<style>\n{_resource('page.css')}</style>\n</head>\n<body>\n"
        f"<h1>{escape(title)}</h1>\n"
        f'<p class="controls">{keys}<label><input type="checkbox" id="log"> logarithmic</label>'
        '<button id="reset">whole plane</button></p>\n'
        '<main><svg id="plane" viewBox="0 0 760 540" role="img" '
        'aria-label="eigenvalues in the complex plane"></svg><section id="mode"></section></main>\n'
        '<div id="tip" hidden></div>\n'
        f'{tables}\n<script type="application/json" id="data">{text}</script>\n'
        f"<script>\n{_resource('page.js')}</script>\n</body>\n</html>\n"
    )


def _resource(name: str) -> str:
    return files("acausal.analysis").joinpath(name).read_text(encoding="utf-8")


def _data(snapshot: Snapshot, name: str) -> dict[str, object]:
    modes = [
        _mode(snapshot, number, mode)
        for number, mode in enumerate(snapshot.modes.modes, 1)
        if mode.eigenvalue.imag >= 0
    ]
    return {"name": name, "states": list(snapshot.states), "modes": modes}


def _mode(snapshot: Snapshot, number: int, mode: Mode) -> dict[str, object]:
    """One mode; of its states those that take part or move."""
    shape = mode.shape[:, 0] / snapshot.nominals
    shape = shape / shape[np.abs(shape).argmax()]
    kept = np.flatnonzero((mode.participation > _SHARE) | (np.abs(shape) > _AMPLITUDE))
    return {
        "number": number,
        "re": mode.eigenvalue.real,
        "im": mode.eigenvalue.imag,
        "hz": mode.frequency_hz,
        "damping": mode.damping_ratio,
        "kind": mode.kind,
        "multiplicity": mode.multiplicity,
        "states": [
            [int(i), *(float(f"{v:.4g}") for v in (mode.participation[i], shape[i].real, shape[i].imag))]
            for i in kept
        ],
    }


def _section(index: int, snapshot: Snapshot, name: str) -> str:
    warnings = "".join(f'<p class="warning">{escape(text)}</p>' for text in snapshot.warnings)
    return f"<h2>{escape(name)}</h2>\n{warnings}{_table(snapshot, index, None)}"


def _table(snapshot: Snapshot, index: int | None, most: int | None) -> str:
    rows = list(_rows(snapshot, index))
    more = len(rows) - most if most is not None else 0
    cut = f"<p><small>and {more} faster modes</small></p>" if more > 0 else ""
    head = "".join(f"<th>{title}</th>" for title in _HEAD)
    limits = ", ".join(f"{k} {_step(v)}" for k, v in snapshot.max_step.items())
    return (
        f"<table>\n<tr>{head}</tr>\n" + "\n".join(rows[:most]) + f"\n</table>{cut}"
        f"<p><small>longest stable step: {limits}</small></p>"
    )


def _step(limit: float) -> str:
    return "any" if limit == inf else "none" if limit == 0 else f"{limit:.4g} s"


def _rows(snapshot: Snapshot, index: int | None) -> Iterator[str]:
    for number, mode in enumerate(snapshot.modes.modes, 1):
        if mode.eigenvalue.imag < 0:
            continue
        constant = mode.time_constant
        of = ", ".join(
            f"<code>{escape(s)}</code> {100 * mode.participation[snapshot.states.index(s)]:.0f} %"
            for s in mode.leading(snapshot.states)
        )
        numbers = (
            str(number),
            value_text(mode.eigenvalue),
            f"{mode.frequency_hz:.4g}",
            f"{mode.damping_ratio:.3f}" if mode.eigenvalue else "",
            "" if constant == inf else f"{constant:.4g}",
            str(mode.multiplicity),
        )
        cells = "".join(f'<td class="number">{text}</td>' for text in numbers)
        key = f' data-mode="{index} {number}"' if index is not None else ""
        yield f"<tr{key}>{cells}<td>{escape(mode.kind)}</td><td>{of}</td></tr>"


def fragment(snapshot: Snapshot) -> str:
    """What a notebook shows: where it is, warnings, the complex plane, the table of modes."""
    from acausal.analysis.drawing import draw_plane  # Matplotlib takes half a second to import

    rest = "at rest" if snapshot.is_equilibrium else "not at rest"
    warnings = "".join(f"<p>⚠ {escape(text)}</p>" for text in snapshot.warnings)
    image = b64encode(draw_plane([snapshot]).as_png(80)).decode()
    return (
        f'<div class="acausal"><h3>{escape(snapshot.model)}, {escape(when(snapshot))}: {rest}</h3>{warnings}'
        f'<img alt="eigenvalues in the complex plane" src="data:image/png;base64,{image}">'
        f"{_table(snapshot, None, _ROWS)}</div>"
    )
