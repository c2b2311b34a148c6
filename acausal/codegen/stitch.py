"""Joins a program's pieces to single Functions with named inputs and outputs.

With the tearing variables `z` of the implicit blocks given, a program is one SX graph: outputs, event
functions and conditions are computed so, from the `z` that the derivatives were solved with. The derivatives
themselves come from an MX graph that calls SX pieces in order, solves each block with `solvers`, and is
differentiated by CasADi through both (implicit function theorem). Without implicit blocks that is SX too.

Measured on a chain of 20 orifice junctions without volumes (one block of 61 equations torn on 20 unknowns):
11 us for the derivatives, 0.6 to 1.2 us for each of the others, against 10 to 11 us if each solves alone.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import casadi as ca
from casadi import MX, SX, Function

from acausal.codegen.casadi_expressions import FORWARD, Converter
from acausal.codegen.factors import Factors
from acausal.codegen.program import Program, explicit_code
from acausal.codegen.scope import Scope, block_scope, column
from acausal.codegen.segments import Segment, expressions, reads
from acausal.codegen.solvers import Nominals, linear, nonlinear, right_side
from acausal.symbolic.causal import BlockKind
from acausal.symbolic.expressions.expr import Expr


@dataclass(frozen=True)
class Goal:
    """One output: the values of `roots`, with relations computed instead of taken as modes if `literal`."""

    name: str
    roots: tuple[Expr, ...]
    literal: bool = False


class Stitching:
    """Makes Functions of one program.

    With the implicit blocks' tearing variables `z` known, everything is one SX graph, converted once for all
    Functions. Only `closed` solves for them.
    """

    def __init__(self, program: Program, nominals: Nominals) -> None:
        self._program = program
        self._nominals = nominals
        self._scope = Scope([*program.groups, ("z", program.guesses)])
        self._scope.run(program.blocks)

    def function(self, name: str, goal: Goal) -> Function:
        """From the program's inputs and `z` to the goal."""
        return self._scope.function(name, [(goal.name, self._scope.column(goal.roots, goal.literal))])

    def column(self, roots: Sequence[Expr], literal: bool = False) -> SX:
        """The values of `roots`, for `made`."""
        return self._scope.column(roots, literal)

    def converter(self) -> Converter:
        """Another conversion over the same known values, to which more may be added."""
        return self._scope.branch()

    def made(
        self, name: str, outputs: Sequence[tuple[str, SX]], more: Sequence[tuple[str, SX]] = ()
    ) -> Function:
        """From the program's inputs, `z` and `more` inputs to the outputs."""
        return self._scope.function(name, outputs, more)

    def closed(self, name: str, goals: Sequence[Goal]) -> Function:
        """From the program's inputs and a guess of `z` to the goals and the solved `z_out`."""
        if not self._program.is_explicit:
            return stitched(self._program, name, goals, self._nominals, None)
        scope = self._scope
        outputs = [(goal.name, scope.column(goal.roots, goal.literal)) for goal in goals]
        return scope.function(name, [*outputs, ("z_out", column([]))])


def stitched(
    program: Program, name: str, goals: Sequence[Goal], nominals: Nominals, factors: Factors | None
) -> Function:
    """As `Stitching.closed`, of a program with implicit blocks; the last input are the `factors`, if any."""
    return _Stitcher(program, name, goals, nominals, factors).function()


class _Stitcher:
    """Builds the MX graph of one Function; holds which vector each value is in."""

    def __init__(
        self,
        program: Program,
        name: str,
        goals: Sequence[Goal],
        nominals: Nominals,
        factors: Factors | None,
    ) -> None:
        self.program = program
        self.factors = factors
        self.factors_in = MX.sym("w", factors.size if factors is not None else 0)
        self.name = name
        self.goals = goals
        self.nominals = nominals
        self.inputs = [MX.sym(group, len(leaves)) for group, leaves in program.groups]
        self.guess_in = MX.sym("z", len(program.guesses))
        self._where: dict[Expr, tuple[int, int]] = {}
        self._vectors: list[MX] = []
        self._solved: list[MX] = []
        self._reached = 0
        for (_, leaves), vector in zip(program.groups, self.inputs, strict=True):
            self._add(leaves, vector)

    def _add(self, values: Sequence[Expr], vector: MX) -> None:
        for offset, value in enumerate(values):
            self._where[value] = (len(self._vectors), offset)
        self._vectors.append(vector)

    def _take(self, values: Sequence[Expr]) -> MX:
        """The column of `values`, gathered from the vectors they are in."""
        parts: list[MX] = []
        pending: list[int] = []
        current = -1
        for value in [*values, None]:
            source, offset = self._where[value] if value is not None else (-1, 0)
            if source != current and pending:
                parts.append(self._vectors[current][pending])
                pending = []
            current = source
            pending.append(offset)
        return ca.vertcat(*parts) if parts else MX(0, 1)

    def function(self) -> Function:
        needed = self._needed()
        for i, (segment, wanted) in enumerate(zip(self.program.segments, needed, strict=True)):
            name = f"{self.name}_{i}"
            if segment.implicit:
                self._solve(segment, name)
            elif wanted:
                code = explicit_code(segment, self.program.slots, wanted, name)
                self._add(code.writes, code.run(self._take(code.reads)))
        outputs = [self._goal(goal) for goal in self.goals]
        names = [goal.name for goal in self.goals]
        outputs.append(ca.vertcat(*self._solved))
        groups = [group for group, _ in self.program.groups]
        inputs, names_in = [*self.inputs, self.guess_in], [*groups, "z"]
        if self.factors is not None:
            inputs, names_in = [*inputs, self.factors_in], [*names_in, "w"]
        return Function(self.name, inputs, outputs, names_in, [*names, "z_out"], FORWARD)

    def _needed(self) -> list[list[Expr]]:
        """Of each segment, the unknowns that later segments or the goals read."""
        slots = self.program.slots
        wanted: set[Expr] = set()
        for goal in self.goals:
            wanted.update(reads(goal.roots, slots, literal=goal.literal))
        result: list[list[Expr]] = []
        for segment in reversed(self.program.segments):
            result.append([unknown for unknown in segment.writes if unknown in wanted])
            wanted.update(reads(expressions(segment.blocks), slots, own=segment.writes))
        return result[::-1]

    def _goal(self, goal: Goal) -> MX:
        known = reads(goal.roots, self.program.slots, literal=goal.literal)
        scope = Scope([("u", known)])
        run = scope.function(
            f"{self.name}_{goal.name}", [(goal.name, scope.column(goal.roots, goal.literal))]
        )
        return run(self._take(known))

    def _solve(self, segment: Segment, name: str) -> None:
        block = segment.block
        slots = self.program.slots
        scales = [self.nominals.of[z] for z in block.tearing if z in self.nominals.of]
        known = reads([*expressions([block]), *scales], slots, own=block.unknowns)
        u = self._take(known)
        inverse = self.factors.inverse(block, self.factors_in) if self.factors is not None else None
        if inverse is not None:
            z = ca.mtimes(inverse, right_side(block, known, name)(u))
        elif block.kind is BlockKind.LINEAR:
            z = linear(block, known, name, self.nominals)(u)
        else:
            guess = self.guess_in[self._reached : self._reached + len(block.tearing)]
            z = nonlinear(block, known, name, self.nominals)(guess, u)
        self._solved.append(z)
        self._reached += len(block.tearing)
        self._add(block.tearing, z)
        if block.assignments:
            z_symbol, u_symbol, scope = block_scope(block, known)
            rest = scope.column([a.value for a in block.assignments])
            run = Function(f"{name}_rest", [z_symbol, u_symbol], [rest], ["z", "u"], ["w"], FORWARD)
            self._add([a.unknown for a in block.assignments], run(z, u))
