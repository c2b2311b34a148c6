"""Maximum bipartite matching of equations with variables: who is solved for what.

Pothen and Fan, "Computing the block triangular form of a sparse matrix", ACM TOMS 16 (1990), in the variant
with look-ahead and fairness of Duff, Kaya and Ucar, "Design, implementation, and analysis of maximum
transversal algorithms", ACM TOMS 38 (2011).
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from acausal.symbolic.graphs.types import Eq, Incidence, Var, check_incidence, equations

_NEVER_AGAIN = 1 << 62
"""A stamp no search ever reaches: the variable is out of the game."""


@dataclass(frozen=True)
class Matching:
    """Pairs of equations and variables, each in at most one pair; `None` means unmatched."""

    var_of_eq: tuple[Var | None, ...]
    eq_of_var: tuple[Eq | None, ...]
    size: int

    def unmatched_equations(self) -> tuple[Eq, ...]:
        """Equations without a variable, ascending."""
        return tuple(Eq(i) for i, var in enumerate(self.var_of_eq) if var is None)

    def unmatched_variables(self) -> tuple[Var, ...]:
        """Variables without an equation, ascending."""
        return tuple(Var(i) for i, eq in enumerate(self.eq_of_var) if eq is None)


class Matcher:
    """A matching that is extended step by step while its graph grows: the working memory of one algorithm.

    Stamps instead of cleared flags make the cost of a search depend only on what it touches, so thousands of
    small extensions of a large matching cost no more than one large extension.
    """

    def __init__(self, incidence: Iterable[Sequence[Var]], n_vars: int) -> None:
        self.rows: list[Sequence[Var]] = list(incidence)
        self.var_of_eq: list[Var | None] = [None] * len(self.rows)
        self.eq_of_var: list[Eq | None] = [None] * n_vars
        self.reached: list[Eq] = []
        """The equations visited by the last phase of `augment`, in order of visit."""
        self._ahead = [0] * len(self.rows)
        self._stamp = [0] * n_vars
        self._phase = 0

    def add_variable(self) -> Var:
        """Append an unmatched variable. O(1)."""
        self.eq_of_var.append(None)
        self._stamp.append(0)
        return Var(len(self.eq_of_var) - 1)

    def add_equation(self, row: Sequence[Var]) -> Eq:
        """Append an unmatched equation with the variables `row`. O(1)."""
        self.rows.append(row)
        self.var_of_eq.append(None)
        self._ahead.append(0)
        return Eq(len(self.rows) - 1)

    def pair(self, eq: Eq, var: Var) -> None:
        """Match `eq` with `var`, whatever either was matched with before. O(1)."""
        self.var_of_eq[eq] = var
        self.eq_of_var[var] = eq

    def retire(self, var: Var) -> None:
        """Never let a search pass through the (matched) variable again. O(1)."""
        self._stamp[var] = _NEVER_AGAIN

    def augment(self, roots: Iterable[Eq]) -> list[Eq]:
        """Match as many of the unmatched `roots` as possible, keeping every matched equation matched.

        First each root takes its first free variable, then phases of depth-first searches for augmenting
        paths run until a phase finds none. Returns the roots left over; `reached` then holds the equations on
        alternating paths from them. O(E) a phase over the part touched; the number of phases is below the
        number of roots, and in practice below about twenty.
        """
        left: list[Eq] = []
        for root in roots:
            var = self._free_variable(root)
            if var is None:
                left.append(root)
            else:
                self.pair(root, var)
        self.reached = []
        while left:
            self._phase += 1
            self.reached = []
            failed = [root for root in left if not self._search(root)]
            if len(failed) == len(left):
                break
            left = failed
        return left

    def freeze(self) -> Matching:
        """The matching as an immutable value. O(V)."""
        size = sum(var is not None for var in self.var_of_eq)
        return Matching(tuple(self.var_of_eq), tuple(self.eq_of_var), size)

    def _free_variable(self, eq: Eq) -> Var | None:
        """Look-ahead: the first unmatched variable of `eq`.

        O(E) over the whole life of the matcher: a variable once matched stays matched, so that the scan
        resumes where it stopped.
        """
        row, owner = self.rows[eq], self.eq_of_var
        for at in range(self._ahead[eq], len(row)):
            if owner[row[at]] is None:
                self._ahead[eq] = at
                return row[at]
        self._ahead[eq] = len(row)
        return None

    def _scan(self, eq: Eq) -> Iterable[Var]:
        """The variables of `eq`, backwards in every second phase (fairness)."""
        return self.rows[eq] if self._phase % 2 else reversed(self.rows[eq])

    def _search(self, root: Eq) -> bool:
        """Search an augmenting path from `root` among variables not yet visited in this phase; use it."""
        stamp, phase, owner = self._stamp, self._phase, self.eq_of_var
        path: list[Eq] = [root]
        taken: list[Var] = []
        scans = [iter(self._scan(root))]
        self.reached.append(root)
        while path:
            for var in scans[-1]:
                if stamp[var] < phase:
                    break
            else:
                path.pop()
                scans.pop()
                if taken:
                    taken.pop()
                continue
            stamp[var] = phase
            eq = owner[var]
            assert eq is not None, "the look-ahead found no free variable here"
            path.append(eq)
            taken.append(var)
            self.reached.append(eq)
            free = self._free_variable(eq)
            if free is not None:
                self._flip(path, [*taken, free])
                return True
            scans.append(iter(self._scan(eq)))
        return False

    def _flip(self, path: list[Eq], variables: list[Var]) -> None:
        """Exchange matched and unmatched edges along an augmenting path."""
        for eq, var in zip(path, variables, strict=True):
            self.pair(eq, var)


def maximum_matching(incidence: Incidence, n_vars: int, order: Sequence[Eq] | None = None) -> Matching:
    """A maximum matching of equations with variables.

    `order` lists the equations to match, those choosing first first (all, ascending, if None); each takes its
    first free variable in its incidence list, and gives it up again only where that lets another equation be
    matched. An equation matched at first stays matched.

    Pothen and Fan 1990 (see the module); O(V E) at worst, O(V + E) a phase and few phases in practice.
    Raises ValueError where the incidence names a variable that does not exist.
    """
    check_incidence(incidence, n_vars)
    matcher = Matcher(incidence, n_vars)
    matcher.augment(equations(len(incidence)) if order is None else order)
    return matcher.freeze()
