"""Joins a program's pieces to one Function with named inputs and outputs.

Without implicit blocks the Function is one SX graph. Otherwise an MX graph calls SX pieces in order, solves linear
blocks with a sparse QR factorisation and nonlinear ones with CasADi's Newton method, and lets CasADi differentiate
through both (implicit function theorem).

Newton works on residuals divided by their size at the guess, `s_i = sum_j |J_ij| (|z_j| + nominal_j)`, so that
pascals and cubic metres per second stop at the same relative accuracy. What it returns is checked in the graph: a
residual above 1e-7 of its size makes the block's values not-a-number, which the integrator answers with a smaller
step and the run-time explains.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import casadi as ca
from casadi import MX, SX, Function

from acausal.codegen.casadi_expressions import FORWARD, jacobian
from acausal.codegen.program import Program, explicit_code
from acausal.codegen.scope import Scope, block_scope, column, split
from acausal.codegen.segments import Segment, expressions, reads
from acausal.symbolic.causal import Block, BlockKind
from acausal.symbolic.expressions.expr import Expr

ACCEPTED = 1e-7
"""Largest residual of a solved nonlinear block, relative to the size of its terms."""
_NEWTON: dict[str, object] = {
    "abstol": 1e-12,
    "abstolStep": 0.0,
    "max_iter": 25,
    "error_on_fail": False,
    "linear_solver": "qr",
    "show_eval_warnings": False,
}


@dataclass(frozen=True)
class Goal:
    """One output: the values of `roots`, with relations computed instead of taken as modes if `literal`."""

    name: str
    roots: tuple[Expr, ...]
    literal: bool = False


@dataclass(frozen=True)
class Nominals:
    """The size of each unknown, as an expression in parameters; 1 where none is declared."""

    of: dict[Expr, Expr]

    def column(self, scope: Scope, unknowns: Sequence[Expr], default: float = 1.0) -> SX:
        other = SX(default)
        return column([ca.fabs(scope.convert(self.of[z])) if z in self.of else other for z in unknowns])


class Stitching:
    """Makes Functions of one program. An explicit program is converted once, whatever number of Functions share it."""

    def __init__(self, program: Program, nominals: Nominals) -> None:
        self._program = program
        self._nominals = nominals
        self._scope: Scope | None = None
        if program.is_explicit:
            self._scope = Scope([*program.groups, ("guess", ())])
            self._scope.run(program.blocks)

    def function(self, name: str, goals: Sequence[Goal], guess: bool = False) -> Function:
        """From the program's inputs and `guess` to the goals (and, if asked for, `guess_out`)."""
        scope = self._scope
        if scope is None:
            return _Stitcher(self._program, name, goals, self._nominals).function(guess)
        outputs = [(goal.name, scope.column(goal.roots, goal.literal)) for goal in goals]
        return scope.function(name, [*outputs, ("guess_out", column([]))] if guess else outputs)


class _Stitcher:
    """Builds the MX graph of one Function; holds which vector each value is in."""

    def __init__(self, program: Program, name: str, goals: Sequence[Goal], nominals: Nominals) -> None:
        self.program = program
        self.name = name
        self.goals = goals
        self.nominals = nominals
        self.inputs = [MX.sym(group, len(leaves)) for group, leaves in program.groups]
        self.guess_in = MX.sym("guess", len(program.guesses))
        self._where: dict[Expr, tuple[int, int]] = {}
        self._vectors: list[MX] = []
        self._guess_out: list[MX] = []
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

    def function(self, guess: bool) -> Function:
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
        if guess:
            outputs.append(ca.vertcat(*self._guess_out) if self._guess_out else MX(0, 1))
            names.append("guess_out")
        groups = [group for group, _ in self.program.groups]
        return Function(self.name, [*self.inputs, self.guess_in], outputs, [*groups, "guess"], names, FORWARD)

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
        run = scope.function(f"{self.name}_{goal.name}", [(goal.name, scope.column(goal.roots, goal.literal))])
        return run(self._take(known))

    def _solve(self, segment: Segment, name: str) -> None:
        block = segment.block
        slots = self.program.slots
        scales = [self.nominals.of[z] for z in block.tearing if z in self.nominals.of]
        known = reads([*expressions([block]), *scales], slots, own=block.unknowns)
        u = self._take(known)
        if block.kind is BlockKind.LINEAR:
            z = linear(block, known, name)(u)
        else:
            start = sum(part.shape[0] for part in self._guess_out)
            guess = self.guess_in[list(range(start, start + len(block.tearing)))]
            z = nonlinear(block, known, name, self.nominals)(guess, u)
            self._guess_out.append(z)
        self._add(block.tearing, z)
        if block.assignments:
            z_symbol, u_symbol, scope = block_scope(block, known)
            rest = scope.column([a.value for a in block.assignments])
            run = Function(f"{name}_rest", [z_symbol, u_symbol], [rest], ["z", "u"], ["w"], FORWARD)
            self._add([a.unknown for a in block.assignments], run(z, u))


def linear(block: Block, known: Sequence[Expr], name: str) -> Function:
    """`u -> z` with `A(u) z = b(u)`: `A` is the exact Jacobian of the residuals, `b` minus their value at 0."""
    z, u, scope = block_scope(block, known)
    residual = scope.column([r.value for r in block.residuals])
    at_zero = Function("residual", [z, u], [residual]).call([SX.zeros(z.shape[0], 1), u])[0]
    system = Function(f"{name}_system", [u], [jacobian(residual, z), -at_zero], ["u"], ["A", "b"], FORWARD)
    values = MX.sym("u", len(known))
    matrix, right = system(values)
    return Function(name, [values], [ca.solve(matrix, right, "qr")], ["u"], ["z"], FORWARD)


def nonlinear(block: Block, known: Sequence[Expr], name: str, nominals: Nominals) -> Function:
    """`(guess, u) -> z` with zero residuals, or not-a-number where Newton's method does not get there."""
    z, u, scope = block_scope(block, known)
    residual = scope.column([r.value for r in block.residuals])
    sizes = ca.mtimes(ca.fabs(jacobian(residual, z)), ca.fabs(z) + nominals.column(scope, block.tearing))
    sizes = ca.densify(sizes)
    constant = {**FORWARD, "is_diff_in": [False, False], "never_inline": True}
    size = Function(f"{name}_size", [z, u], [sizes], ["z", "u"], ["s"], constant)
    met = [ca.fabs(r) <= ACCEPTED * s for r, s in zip(split(residual), split(sizes), strict=True)]
    verdict = column([ca.if_else(ok, 0.0, float("nan")) for ok in met])
    check = Function(f"{name}_check", [z, u], [verdict], ["z", "u"], ["v"], constant)
    s = SX.sym("s", z.shape[0])
    oracle = Function(
        f"{name}_newton", [z, ca.vertcat(u, s)], [residual / s], ["x", "p"], ["g"], {**FORWARD}
    )
    solver = ca.rootfinder(f"{name}_root", "newton", oracle, _NEWTON)
    guess, values = MX.sym("guess", len(block.tearing)), MX.sym("u", len(known))
    found = solver(guess, ca.vertcat(values, size(guess, values)))
    total = found + ca.sum1(check(found, values))
    return Function(name, [guess, values], [total], ["guess", "u"], ["z"], FORWARD)
