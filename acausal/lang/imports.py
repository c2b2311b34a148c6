"""Import clauses of a class, by the name they make visible (Modelica 3.6, 13.2.1)."""

from __future__ import annotations

from acausal.lang import ast
from acausal.lang.light import light_object


@light_object
class Imported:
    """One name made visible: the full name it stands for, and the clause."""

    target: tuple[str, ...]
    clause: ast.Import


@light_object
class Imports:
    """Qualified imports by the visible name, and the clauses `import A.*`."""

    named: dict[str, Imported]
    wildcards: tuple[ast.Import, ...]


def imports_of(definition: ast.ClassDefinition) -> Imports:
    """The imports that a class's text declares; those of enclosing and base classes are not among them."""
    named: dict[str, Imported] = {}
    wildcards: list[ast.Import] = []
    elements = definition.body.elements if isinstance(definition, ast.LongClass) else ()
    for element in elements:
        if not isinstance(element, ast.Import):
            continue
        if element.wildcard:
            wildcards.append(element)
        elif element.group:
            for name in element.group:
                named.setdefault(name, Imported((*element.name, name), element))
        else:
            shown = element.alias if element.alias is not None else element.name[-1]
            named.setdefault(shown, Imported(element.name, element))
    return Imports(named, tuple(wildcards))
