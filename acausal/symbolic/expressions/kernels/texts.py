"""Numbers, Booleans and enumeration literals as texts: Modelica's `String(...)` (3.6, 3.7.1.2)."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

from acausal.symbolic.expressions.kernel import Kernel, digest
from acausal.symbolic.expressions.node import Constant


@dataclass(frozen=True, eq=False)
class TextOf(Kernel):
    """`format % value`, then padded to `length`: on the right if `left` justified, else on the left.

    `literals` are those of an enumeration, whose index is the argument.
    """

    format: str
    length: int
    left: bool
    literals: tuple[str, ...]
    key: str
    name: str = "String"
    arity: int = 1
    result: str = "String"
    continuity: int = -1

    @property
    def is_discrete(self) -> bool:
        return True

    def evaluate(self, *args: Constant) -> Constant:
        text = self._plain(args[0])
        return text.ljust(self.length) if self.left else text.rjust(self.length)

    def _plain(self, value: Constant) -> str:
        if self.literals:
            return self.literals[int(value) - 1] if isinstance(value, (int, float)) else str(value)
        if isinstance(value, bool) or not isinstance(value, (int, float)):
            return str(value).lower() if isinstance(value, bool) else str(value)
        whole = self.format[-1] in "diouxXc"
        return f"%{self.format}" % (round(value) if whole else value)

    @property
    def options(self) -> str:
        """The arguments behind the value, as Modelica writes them; those with their defaults are left out."""
        found: list[str] = []
        digits = re.fullmatch(r"\.(\d+)g", self.format)
        if digits is not None and digits[1] != "6":
            found.append(f"significantDigits = {digits[1]}")
        elif digits is None and self.format not in ("d", "s"):
            found.append(f'format = "{self.format}"')
        if self.length:
            found.append(f"minimumLength = {self.length}")
        if not self.left:
            found.append("leftJustified = false")
        return "".join(f", {option}" for option in found)

    def partial(self, argument: int) -> Kernel | None:
        return None


def text_of(format_: str, length: int, left: bool, literals: Sequence[str] = ()) -> TextOf:
    """The kernel with these parts."""
    key = digest("text", format_, length, left, tuple(literals))
    return TextOf(format_, length, left, tuple(literals), key)
