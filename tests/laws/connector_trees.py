"""Random connection networks: parts with arrays of pins, nested in groups with pins of their own."""

from __future__ import annotations

from dataclasses import dataclass

from hypothesis import strategies as st

PREAMBLE = """connector Pin
  Real v;
  flow Real i;
end Pin;
model Part
  parameter Integer n = 1;
  Pin p[n];
equation
  for k in 1:n loop
    p[k].v = k * p[k].i + time;
  end for;
end Part;
"""


@dataclass(frozen=True)
class Group:
    """A model: pins of its own, parts (numbers of their pins), groups, and pairs of pins to connect.

    A pin is numbered through: own pins, then those of the parts, then those of the groups.
    """

    own: int
    parts: tuple[int, ...]
    groups: tuple[Group, ...]
    connections: tuple[tuple[int, int], ...]

    def pins(self) -> list[str]:
        """The names of all pins that the group's connect equations can use."""
        names = [f"g[{k}]" for k in range(1, self.own + 1)]
        names += [f"part{j}.p[{k}]" for j, n in enumerate(self.parts) for k in range(1, n + 1)]
        names += [f"group{j}.g[{k}]" for j, g in enumerate(self.groups) for k in range(1, g.own + 1)]
        return names

    def text(self, name: str) -> str:
        """The classes of the group and of those in it."""
        inner = [group.text(f"{name}_{j}") for j, group in enumerate(self.groups)]
        pins = self.pins()
        lines = [f"model {name}"]
        lines += [f"  Pin g[{self.own}];"] if self.own else []
        lines += [f"  Part part{j}(n = {n});" for j, n in enumerate(self.parts)]
        lines += [f"  {name}_{j} group{j};" for j in range(len(self.groups))]
        lines.append("equation")
        lines += [f"  connect({pins[a]}, {pins[b]});" for a, b in self.connections]
        return "\n".join([*inner, *lines, f"end {name};"])

    def all_pins(self, path: str = "") -> list[str]:
        """Flat names of every pin of the group and of what is in it."""
        own = [f"{path}g[{k}]" for k in range(1, self.own + 1)]
        own += [f"{path}part{j}.p[{k}]" for j, n in enumerate(self.parts) for k in range(1, n + 1)]
        for j, group in enumerate(self.groups):
            own += group.all_pins(f"{path}group{j}.")
        return own

    def all_connections(self, path: str = "") -> list[tuple[str, str]]:
        """Flat names of the two pins of every connect equation."""
        pins = self.pins()
        found = [(path + pins[a], path + pins[b]) for a, b in self.connections]
        for j, group in enumerate(self.groups):
            found += group.all_connections(f"{path}group{j}.")
        return found


@st.composite
def groups(draw: st.DrawFn, depth: int = 2, top: bool = True) -> Group:
    """A group whose own pins are all connected inside, as the outside relies on them."""
    own = 0 if top else draw(st.integers(1, 3))
    parts = tuple(draw(st.lists(st.integers(1, 3), min_size=1, max_size=3)))
    inner = draw(st.lists(groups(depth - 1, False), max_size=2)) if depth else []
    skeleton = Group(own, parts, tuple(inner), ())
    count = len(skeleton.pins())
    others = st.integers(own, count - 1)
    connections = [(k, draw(others)) for k in range(own)]
    pairs = st.tuples(st.integers(0, count - 1), others).filter(lambda pair: pair[0] != pair[1])
    if count > 1:
        connections += draw(st.lists(pairs, max_size=6))
    return Group(own, parts, tuple(inner), tuple(connections))
