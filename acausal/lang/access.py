"""What may be reached by dot notation and by imports (Modelica 3.6, 4.1, 5.3.2 and 13.2.1).

`check_inside` judges one step `A.B` into a class, `check_import` the package of an import clause, and
`check_complete` that a class looked into is not partial, which only matters in the model that is built.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from acausal.errors import LookupProblem, Span, TypeProblem, fail
from acausal.lang import ast

if TYPE_CHECKING:  # a scope asks here before it looks inside another
    from acausal.lang.class_table import ClassEntry, ComponentEntry
    from acausal.lang.scope import Scope


def check_inside(scope: Scope, entry: ClassEntry | ComponentEntry, span: Span) -> None:
    """`scope.entry` is public, of a package or encapsulated. Raises `lookup.protected` and others."""
    if is_protected(scope, entry):
        raise fail(
            TypeProblem,
            "lookup.protected",
            f"`{entry.name}` is protected in `{scope.path}` and cannot be used from outside",
            span,
            names=[f"{scope.path}.{entry.name}"],
            hint="make it public, or inherit from the class to use it (Modelica 3.6, 4.1)",
        )
    if not (scope.kind in ("package", "operator") or _is_encapsulated(entry) or is_package_like(scope)):
        raise fail(
            LookupProblem,
            "lookup.not-package",
            f"`{entry.name}` cannot be reached through the {scope.kind} `{scope.path}`, which is no package",
            span,
            names=[f"{scope.path}.{entry.name}"],
            hint=f"declare `{entry.name}` encapsulated, or move it into a package (Modelica 3.6, 5.3.2)",
        )


def is_protected(scope: Scope, entry: ClassEntry | ComponentEntry) -> bool:
    """Whether an element of the class is protected there, also by a protected `extends`."""
    definition, table = _definition(entry), scope.known_table
    if definition is None:
        return table is not None and table.components[entry.name].protected
    return definition.prefixes.protected or (table is not None and entry.name in table.hidden)


def _definition(entry: ClassEntry | ComponentEntry) -> ast.ClassDefinition | None:
    node = getattr(entry, "node", None)
    return None if node is None else node.definition


def _is_encapsulated(entry: ClassEntry | ComponentEntry) -> bool:
    definition = _definition(entry)
    return definition is not None and definition.class_prefixes.encapsulated


def is_package_like(scope: Scope) -> bool:
    """Whether a class has nothing but classes and constants: what a package may contain.

    While its bases are being resolved, that is not known, and it passes.
    """
    table = scope.known_table
    if table is None:
        return True
    constant = [entry.clause.variability == "constant" for entry in table.components.values()]
    return not table.sections and all(constant)


def check_import(scope: Scope, target: str, span: Span) -> None:
    """Imports come from packages only (13.2.1). Raises `import.not-package`."""
    if scope.kind != "package":
        raise fail(
            LookupProblem,
            "import.not-package",
            f"`{target}` cannot be imported: `{scope.path}` is a {scope.kind}, not a package",
            span,
            names=[target],
            hint="imports take elements of packages (Modelica 3.6, 13.2.1)",
        )


def check_complete(scope: Scope, name: str, span: Span) -> None:
    """A class that is looked into is not partial (5.3.2). Raises `lookup.partial`."""
    if is_partial(scope):
        raise fail(
            LookupProblem,
            "lookup.partial",
            f"`{name}` is looked up in `{scope.path}`, which is partial",
            span,
            names=[f"{scope.path}.{name}"],
            hint=f"redeclare `{scope.node.name}` with a class that is complete (Modelica 3.6, 5.3.2)",
        )


def is_partial(scope: Scope) -> bool:
    """`partial`, or a short class definition of a partial class (4.5.1)."""
    current = scope
    while not current.definition.class_prefixes.partial:
        if not isinstance(current.definition, ast.ShortClass) or current.is_predefined:
            return False
        current = current.table.bases[0].scope
    return True


def check_not_replaceable(scope: Scope, reference: ast.ComponentReference) -> None:
    """The class of an `extends` clause cannot change (6.3.1, 7.1.4). Raises `extends.replaceable`."""
    for current in _steps(scope, reference):
        if _is_replaceable(current):
            raise fail(
                TypeProblem,
                "extends.replaceable",
                f"`{scope.path}` extends `{reference.text}`, but `{current.node.name}` is replaceable",
                reference.span,
                names=[scope.path, current.path],
                hint="extend a class that is not replaceable (Modelica 3.6, 7.1.4)",
            )


def _is_replaceable(scope: Scope) -> bool:
    """Whether a class, or what its short definition stands for, may be redeclared."""
    if scope.definition.prefixes.replaceable:
        return True
    if not isinstance(scope.definition, ast.ShortClass) or scope.known_table is None:
        return False
    return _is_replaceable(scope.known_table.bases[0].scope)


def _steps(scope: Scope, reference: ast.ComponentReference) -> list[Scope]:
    """The classes that the parts of a class's name stand for, one after the other."""
    first = reference.parts[0].name
    current = scope.root.top(first) if reference.global_ else scope.find(first)
    found: list[Scope] = []
    for part in (*reference.parts[1:], None):
        if not isinstance(current, type(scope)):  # a component
            break
        found.append(current)
        if part is not None:
            current = current.find_nested(part.name, part.span)
    return found
