"""The command line that docs/command-line.md promises: `acausal check`, `compile`, `explain`, `simulate`."""

from __future__ import annotations

import sys
from collections.abc import Sequence


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line and return its exit status: 0 well, 1 the model is wrong, 2 the command is."""
    from acausal.cli.app import app
    from acausal.cli.guard import guarded

    words = list(sys.argv[1:] if arguments is None else arguments)
    return guarded(lambda: app(words, prog_name="acausal", standalone_mode=False), as_json="--json" in words)
