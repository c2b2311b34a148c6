"""A stored result read back: columns of numbers by name."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from acausal.errors import UsageProblem, fail
from acausal.results.stored import read_result
from acausal.study.metrics.traces import Trace, Vector

_LARGEST = 1e150
"""What is larger overflows where it is squared."""


@dataclass(frozen=True, eq=False)
class Table:
    """Columns by name, all of one length; `time` is one of them."""

    columns: Mapping[str, Vector]

    def trace(self, name: str) -> Trace:
        """One signal. Raises UsageProblem `metrics.missing-signal`, `metrics.not-a-number`."""
        if name not in self.columns:
            raise fail(
                UsageProblem,
                "metrics.missing-signal",
                f"the result has no signal `{name}`",
                names=[name],
                hint=f"store it: acausal simulate ... -v {name}",
            )
        time, values = self.columns["time"], self.columns[name]
        for column, text in ((time, "time"), (values, name)):
            wrong = ~(np.abs(column) < _LARGEST)
            if wrong.any():
                row = int(np.argmax(wrong))
                what = "is not a number" if np.isnan(column[row]) else "is infinite or far too large"
                where = f"in row {row + 1}" if text == "time" else f"at {float(time[row]):g} s"
                raise fail(
                    UsageProblem,
                    "metrics.not-a-number",
                    f"`{text}` {what} {where}",
                    names=[text],
                    hint="measure a result that is complete",
                )
        return Trace(time, values)

    def traces(self, prefix: str) -> dict[str, Trace]:
        """All signals whose name begins with `prefix`, by the rest of their names."""
        return {
            name.removeprefix(prefix): self.trace(name) for name in self.columns if name.startswith(prefix)
        }


def read_table(path: Path) -> Table:
    """A file that `acausal simulate -o` wrote. Raises UsageProblem `metrics.not-a-result`."""
    try:
        found = read_result(path)
    except UsageProblem as problem:
        first = problem.diagnostics[0]
        raise fail(UsageProblem, "metrics.not-a-result", first.message, hint=first.hint) from None
    return Table({"time": found.time, **{name: found.values(name) for name in found.names}})
