"""What the symbolic core did with a model and why: the one object that every renderer shows."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from acausal.errors import Diagnostic, LookupProblem, UsageProblem, fail
from acausal.explain.collect import (
    Dependencies,
    Differentiated,
    Incidence,
    dependencies,
    differentiated,
    incidence,
)
from acausal.lang.flat import Equation
from acausal.pipeline import Compilation
from acausal.symbolic.causal import Block, BlockKind, CausalSystem
from acausal.symbolic.homotopy import homotopy_equations


@dataclass(frozen=True, eq=False)
class Explanation:
    """A causalised system, what it cost, and what can be asked about it.

    `print(explanation)` and `.text` tell the story; a notebook shows it; `.to_json()` is for programs.
    """

    system: CausalSystem
    warnings: tuple[Diagnostic, ...]
    seconds: Mapping[str, float]

    @property
    def name(self) -> str:
        return self.system.flat.name

    @cached_property
    def differentiated(self) -> tuple[Differentiated, ...]:
        """Equations that had to be differentiated, and how often."""
        return differentiated(self.system)

    @cached_property
    def homotopies(self) -> tuple[Equation, ...]:
        """The equations whose simplified side the initial problem may start from."""
        flat = self.system.homotopy
        return () if flat is None else homotopy_equations(flat)

    @cached_property
    def dependencies(self) -> Dependencies:
        """Which block needs which."""
        return dependencies(self.system)

    @cached_property
    def incidence(self) -> Incidence:
        """Which unknown stands in which equation, before and after sorting."""
        return incidence(self.system)

    @cached_property
    def loops(self) -> tuple[tuple[int, Block], ...]:
        """The blocks that have to be solved, linear or not, with their numbers."""
        numbered = enumerate(self.system.blocks, 1)
        return tuple((number, block) for number, block in numbered if block.kind is not BlockKind.EXPLICIT)

    def count(self, kind: BlockKind) -> int:
        """How many blocks are of a kind."""
        return sum(block.kind is kind for block in self.system.blocks)

    def block(self, number: int) -> Block:
        """A block by its number, counted from 1. Raises `UsageProblem` where there is none."""
        blocks = self.system.blocks
        if not 1 <= number <= len(blocks):
            hint = f"blocks are numbered from 1 to {len(blocks)}" if blocks else "it has no blocks at all"
            raise fail(UsageProblem, "usage.block", f"{self.name} has no block {number}", hint=hint)
        return blocks[number - 1]

    def block_of(self, unknown: str) -> int:
        """The number of the block that gives `x` or `der(x)`. Raises `LookupProblem` where none does."""
        from acausal.symbolic.expressions.text import to_text

        for leaf, number in self.dependencies.producer.items():
            if to_text(leaf) == unknown:
                return number
        raise fail(
            LookupProblem,
            "explain.unknown",
            f"no block of {self.name} is solved for `{unknown}`",
            names=[unknown],
            hint="states, parameters and aliases are not solved for",
        )

    @property
    def text(self) -> str:
        """The story as text, long lists cut."""
        from acausal.explain.text import explanation_text

        return explanation_text(self)

    def block_text(self, number: int, *, latex: bool = False) -> str:
        """One block as text, its equations in LaTeX as well if asked for."""
        from acausal.explain.block import block_text

        return block_text(self, number, latex=latex)

    def to_json(self) -> dict[str, object]:
        """What `acausal explain --json` prints."""
        from acausal.explain.data import explanation_data

        return explanation_data(self)

    def html(self) -> str:
        """One page with everything that needs nothing else, neither files nor JavaScript."""
        from acausal.explain.html import html_page

        return html_page(self)

    def plot(self, path: str | Path) -> None:
        """Draw the incidence before and after sorting as PNG, SVG or PDF."""
        from acausal.explain.plot import write_incidence

        write_incidence(self, Path(path))

    def _repr_html_(self) -> str:
        from acausal.explain.html import html_fragment

        return html_fragment(self)

    def __str__(self) -> str:
        return self.text

    def __repr__(self) -> str:
        return f"<Explanation of {self.name}: {len(self.system.blocks)} blocks>"


def explain(compilation: Compilation) -> Explanation:
    """The explanation of a model that was compiled at least as far as the stage `causal`."""
    if compilation.causal is None or compilation.flat is None:
        raise fail(UsageProblem, "usage.stage", "the compilation stopped before the stage `causal`")
    return Explanation(compilation.causal, compilation.warnings, compilation.seconds)
