"""Calls of the command line within the process, and the models they are about."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import cast

import pytest

from acausal.cli import main

TANK = """\
model Tank "A tank that empties"
  parameter Real hole(unit = "m2") = 1e-3 "Area of the hole";
  parameter Integer n = 2 "How many tanks";
  parameter Boolean open = true "Whether it empties";
  final parameter Real surface(unit = "m2") = 0.5 "Area of the surface";
  Real h(unit = "m", start = 1, fixed = true) "Depth";
  Real v(unit = "m/s") "Speed of the jet";
protected
  Real hidden(unit = "m") = 2*h "Not shown unless asked for";
equation
  v = sqrt(2*9.81*h);
  surface*der(h) = if open then -hole*v*n else 0;
  annotation(experiment(StopTime = 10));
end Tank;
"""


@dataclass(frozen=True)
class Done:
    """What a call returned and printed."""

    status: int
    out: str
    err: str

    @property
    def json(self) -> object:
        return json.loads(self.out, parse_constant=_refuse)

    @property
    def data(self) -> dict[str, object]:
        value = self.json
        assert isinstance(value, dict)
        return cast("dict[str, object]", value)

    def below(self, key: str) -> dict[str, object]:
        """The object under a key."""
        value = self.data[key]
        assert isinstance(value, dict)
        return cast("dict[str, object]", value)

    @property
    def problems(self) -> list[dict[str, object]]:
        value = self.json
        assert isinstance(value, list)
        return cast("list[dict[str, object]]", value)


def _refuse(constant: str) -> float:
    raise AssertionError(f"{constant} is not JSON")


@dataclass(frozen=True)
class Call:
    """Runs the command line and keeps what it printed."""

    capture: pytest.CaptureFixture[str]

    def __call__(self, *words: str) -> Done:
        status = main(words)
        out, err = self.capture.readouterr()
        assert "Traceback" not in out + err
        return Done(status, out, err)
