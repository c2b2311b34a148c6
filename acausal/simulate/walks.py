"""How often a run had to solve its blocks by walks, and whether that still leads anywhere."""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass, field

_MOST = 5000
"""So many times a run solves its blocks by homotopy, if need be."""
_IN_VAIN = 5
"""After so many failures in a row it no longer does."""
_CREEPING, _SHARE = 400, 1e-6
"""So many walks within this share of the simulated time are the last: the run creeps along a fold."""


@dataclass
class Walks:
    """The walks of one run, which lasts `span` (s)."""

    span: float = 0.0
    count: int = 0
    in_vain: int = 0
    """Failures in a row."""
    is_stuck: bool = False
    """Whether there is no more to be had from walks."""
    _times: deque[float] = field(default_factory=lambda: deque(maxlen=_CREEPING))

    @property
    def may_fail(self) -> bool:
        """Whether another failure is affordable."""
        return self.in_vain < _IN_VAIN

    @property
    def may_be_long(self) -> bool:
        """Whether one by homotopy is affordable."""
        return self.count <= _MOST and self.may_fail

    def begin(self, time: float) -> bool:
        """Counts one at `time`; False where the run is stuck."""
        self.count += 1
        self._times.append(time)
        if len(self._times) == _CREEPING and max(self._times) - min(self._times) <= _SHARE * self.span:
            self.is_stuck = True
        return not self.is_stuck

    def end(self, *, found: bool) -> None:
        """Notes how it went."""
        self.in_vain = 0 if found else self.in_vain + 1
