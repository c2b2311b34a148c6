"""Figures and pages of snapshots: the same bytes each time, everything labelled, nothing from elsewhere."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pytest

import acausal
from acausal.analysis.animation import animate
from acausal.analysis.drawing import draw_plane
from acausal.analysis.page import page
from acausal.analysis.snapshot import Snapshot
from acausal.errors import UsageProblem

SWING = """model Swing "Slow and fast" input Real f(start = 0); output Real y;
  Real '</script>x$'(start = 0), v(start = 0), T(start = 0);
equation der('</script>x$') = v; der(v) = f - 1e6*'</script>x$' - 20*v; der(T) = -0.01*T; y = v; end Swing;"""


@pytest.fixture(scope="module")
def snapshot() -> Snapshot:
    return acausal.loads(SWING).compile().linearize()


def test_the_plane_is_labelled(snapshot: Snapshot, tmp_path: Path) -> None:
    figure = draw_plane([snapshot, snapshot], tmp_path / "a.png", ["one", "other"])
    axes = figure.axes[0]
    assert (axes.get_xlabel(), axes.get_xscale()) == ("real part [1/s], logarithmic", "symlog")
    assert axes.get_ylabel().startswith("imaginary part [rad/s]")
    draw_plane([snapshot, snapshot], tmp_path / "b.png", ["one", "other"])
    assert (tmp_path / "a.png").read_bytes() == (tmp_path / "b.png").read_bytes()
    with pytest.raises(UsageProblem):
        snapshot.plot(tmp_path / "a.txt")


def test_shapes_and_responses(snapshot: Snapshot, tmp_path: Path) -> None:
    number = next(i for i, m in enumerate(snapshot.modes.modes) if m.eigenvalue.imag > 0)
    figure = snapshot.plot_shape(number, tmp_path / "shape.svg")
    names = [text.get_text() for text in figure.axes[0].get_yticklabels()]
    assert any("x" in name for name in names)
    assert "T" not in names
    bode = snapshot.bode()
    assert (bode.outputs, bode.inputs) == (("y",), ("f",))
    assert bode.plot(tmp_path / "bode.svg").axes[1].get_ylabel() == "phase [deg]"
    peak = bode.frequency[np.argmax(bode.magnitude[0, 0])]
    assert peak == pytest.approx(1000 / (2 * np.pi), rel=0.05)
    animate(snapshot, number, tmp_path / "mode.gif")
    assert (tmp_path / "mode.gif").read_bytes().startswith(b"GIF89a")


def test_the_page_holds_its_data(snapshot: Snapshot) -> None:
    text = page("A <title>", [snapshot], ["at rest"], [[(-1.0, 2.0), (-2.0, 3.0)]], chosen=2)
    assert "<title>A &lt;title&gt;</title>" in text
    assert not re.search(r'(src|href)="', text)
    found = re.search(r'<script type="application/json" id="data">(.*?)</script>', text, re.DOTALL)
    assert found is not None
    data = json.loads(found[1])
    assert data["snapshots"][0]["states"] == list(snapshot.states)
    assert [m["number"] for m in data["snapshots"][0]["modes"]] == [1, 2]
    assert (data["chosen"], data["tracks"]) == (2, [[[-1.0, 2.0], [-2.0, 3.0]]])
    assert text.count("</script>") == 2


def test_what_a_notebook_shows(snapshot: Snapshot) -> None:
    text = snapshot._repr_html_()  # pyright: ignore[reportPrivateUsage]
    assert "data:image/png;base64," in text
    assert "&lt;/script&gt;" in text
    assert "at rest" in text
