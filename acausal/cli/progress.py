"""How far a run is, for a person who waits, and Ctrl-C that stops it where it can go on."""

from __future__ import annotations

import signal
import sys
import threading
from collections.abc import Generator
from contextlib import contextmanager
from time import monotonic, process_time
from types import FrameType

_PERIOD = 0.2
_WIDTH = 30


class Progress:
    """One line on standard error, if that is a terminal; raises `KeyboardInterrupt` once Ctrl-C was hit."""

    def __init__(self, start: float, stop: float) -> None:
        self._start, self._stop = start, stop
        self._shown = sys.stderr.isatty()
        self._last = monotonic()
        self._began = process_time()
        self._wanted = False

    def __call__(self, time: float) -> None:
        if self._wanted:
            raise KeyboardInterrupt
        if self._shown and monotonic() - self._last >= _PERIOD:
            self._last = monotonic()
            print(
                f"\r\x1b[K{self.line(time, process_time() - self._began)}",
                end="",
                file=sys.stderr,
                flush=True,
            )

    def line(self, time: float, spent: float) -> str:
        """The bar, the simulated time, and how much CPU time one simulated second takes."""
        done = time - self._start
        share = min(1.0, done / (self._stop - self._start)) if self._stop > self._start else 1.0
        bar = "#" * round(share * _WIDTH)
        factor = f", {spent / done:.3g} times real time" if done > 0 else ""
        return f"[{bar:<{_WIDTH}}] {share:4.0%}  {time:.6g} of {self._stop:g} s{factor}"

    def _note(self, number: int, frame: FrameType | None) -> None:
        """The first Ctrl-C waits for the next good place to stop, the second does not."""
        del number, frame
        if self._wanted:
            raise KeyboardInterrupt
        self._wanted = True

    @contextmanager
    def watching(self) -> Generator[None]:
        """While the run goes on."""
        is_main = threading.current_thread() is threading.main_thread()
        before = signal.signal(signal.SIGINT, self._note) if is_main else None
        try:
            yield
        finally:
            if is_main:
                signal.signal(signal.SIGINT, before)
            if self._shown:
                print("\r\x1b[K", end="", file=sys.stderr, flush=True)
