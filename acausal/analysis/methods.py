"""What a compiled model can be asked about its behaviour near a point. Importing this costs nothing."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    from acausal.analysis.batch import Values, Variants
    from acausal.analysis.linearize import At
    from acausal.analysis.snapshot import Snapshot
    from acausal.analysis.stored import Columns
    from acausal.analysis.sweep import Locus
    from acausal.codegen.functions import Code
    from acausal.simulate.inputs import InputValue
    from acausal.simulate.overrides import Override
    from acausal.simulate.result import Result


class Linearizing(Protocol):
    """Snapshots, many variants of them, and roots over a parameter, of whatever has code.

    `parameters`, `start` and `inputs` are those of `simulate`: nothing compiles again.
    """

    @property
    def code(self) -> Code: ...

    def linearize(
        self,
        at: At = "initial",
        *,
        parameters: Mapping[str, Override] | None = None,
        start: Mapping[str, float] | None = None,
        inputs: Mapping[str, InputValue] | None = None,
    ) -> Snapshot:
        """A, B, C, D, eigenvalues and modes at the start, at the steady state near it, or `at` seconds.

        See `acausal.analysis.linearize.linearize`, also for what is raised.
        """
        return self.snapshots([at], parameters=parameters, start=start, inputs=inputs)[0]

    def snapshots(
        self,
        at: Sequence[At],
        *,
        parameters: Mapping[str, Override] | None = None,
        start: Mapping[str, float] | None = None,
        inputs: Mapping[str, InputValue] | None = None,
        result: Columns | Result | None = None,
    ) -> tuple[Snapshot, ...]:
        """`linearize` at several instants, which one run visits; or instants of a stored `result`.

        `result` is one of `simulate`, or columns by name: `time`, each state, each discrete variable; see
        `acausal.analysis.stored.stored_snapshots`.
        """
        from acausal.analysis.linearize import Setting, snapshots
        from acausal.analysis.stored import columns_of, stored_snapshots

        setting = Setting(parameters or {}, start or {}, inputs or {})
        if result is not None:
            table = result if isinstance(result, Mapping) else columns_of(self.code, result)
            return stored_snapshots(self.code, table, at, setting)
        return snapshots(self.code, at, setting)

    def variants(
        self,
        parameters: Mapping[str, Values],
        at: At = "initial",
        *,
        start: Mapping[str, Values] | None = None,
        inputs: Mapping[str, InputValue] | None = None,
    ) -> Variants:
        """Many variants linearised in one call; `.eigenvalues` has a row for each.

        See `acausal.analysis.batch.variants`, also for what is raised.
        """
        from acausal.analysis.batch import variants

        return variants(self.code, parameters, at, start=start, inputs=inputs)

    def root_locus(
        self,
        name: str,
        values: Sequence[float],
        at: At = "initial",
        *,
        parameters: Mapping[str, Override] | None = None,
        start: Mapping[str, float] | None = None,
        inputs: Mapping[str, InputValue] | None = None,
    ) -> Locus:
        """The eigenvalues followed over a parameter or a start value; see `acausal.analysis.sweep.sweep`."""
        from acausal.analysis.linearize import Setting
        from acausal.analysis.sweep import sweep

        return sweep(self.code, name, values, at, Setting(parameters or {}, start or {}, inputs or {}))
