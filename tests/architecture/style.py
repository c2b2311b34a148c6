"""The measurable rules of the house style, each a function from a parsed file to its offences."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TypeGuard

MAX_FILE_LINES = 400
MAX_FUNCTION_LINES = 60

# Imports whose results differ from run to run.
RANDOM_MODULES = frozenset({"random", "secrets", "uuid"})
# Calls that do not care in which order their argument comes.
ORDER_BLIND = frozenset({"all", "any", "frozenset", "len", "max", "min", "set", "sorted"})
# Calls that hand the order of their argument on.
ORDER_KEEPING = frozenset({"dict", "enumerate", "iter", "list", "map", "filter", "tuple", "zip"})
# Calls that make text or an order of their arguments.
SHOWING = frozenset({"format", "hex", "print", "repr", "str"})

Function = ast.FunctionDef | ast.AsyncFunctionDef


@dataclass(frozen=True)
class Offence:
    """What is wrong, and where."""

    line: int
    message: str


def long_functions(tree: ast.Module) -> Iterator[Offence]:
    """Functions whose code, docstring not counted, is too long."""
    for node in ast.walk(tree):
        if isinstance(node, Function):
            lines = (node.end_lineno or node.lineno) - node.lineno + 1 - _docstring_lines(node)
            if lines > MAX_FUNCTION_LINES:
                yield Offence(node.lineno, f"{node.name} has {lines} lines, at most {MAX_FUNCTION_LINES}")


def _docstring_lines(node: Function) -> int:
    first = node.body[0]
    if ast.get_docstring(node) is None:
        return 0
    return (first.end_lineno or first.lineno) - first.lineno + 1


def random_sources(tree: ast.Module) -> Iterator[Offence]:
    """Imports of random numbers, `hash` outside `__hash__`, and `id` where it can reach text or an order."""
    for node in ast.walk(tree):
        match node:
            case ast.Import():
                names = [alias.name for alias in node.names]
            case ast.ImportFrom(module=str(module)):
                names = [module, *(f"{module}.{alias.name}" for alias in node.names)]
            case _:
                continue
        for name in names:
            if name.split(".")[0] in RANDOM_MODULES or name == "numpy.random":
                yield Offence(node.lineno, f"{name} is not deterministic")
    yield from _address_sources(tree)


def _address_sources(tree: ast.Module) -> Iterator[Offence]:
    inside_hash = {
        call
        for node in ast.walk(tree)
        if isinstance(node, Function) and node.name == "__hash__"
        for call in ast.walk(node)
    }
    for node in ast.walk(tree):
        if _calls(node, frozenset({"hash"})) and node not in inside_hash:
            yield Offence(node.lineno, "hash() of a string differs from run to run")
        if isinstance(node, ast.JoinedStr) or _calls(node, SHOWING | {"sorted"}):
            yield from (
                Offence(inner.lineno, "id() must not reach text or an order")
                for inner in ast.walk(node)
                if _calls(inner, frozenset({"id"}))
            )
        if isinstance(node, ast.keyword) and node.arg == "key" and _is_name(node.value, frozenset({"id"})):
            yield Offence(node.value.lineno, "id is no key to sort by")


def set_orders(tree: ast.Module) -> Iterator[Offence]:
    """Places that depend on the order of a set, which differs from run to run: sort it first."""
    blind = {
        id(argument)
        for node in ast.walk(tree)
        if _calls(node, ORDER_BLIND)
        for argument in node.args
        if isinstance(argument, ast.GeneratorExp | ast.ListComp)
    }
    for scope, names in _scopes(tree):
        for node in _own_nodes(scope):
            for iterated in _iterated(node, blind):
                if _is_set(iterated, names):
                    yield Offence(iterated.lineno, "the order of a set is arbitrary: sort it, or use a dict")


def _iterated(node: ast.AST, blind: set[int]) -> Iterator[ast.expr]:
    """The expressions whose order `node` depends on."""
    match node:
        case ast.For() | ast.AsyncFor():
            yield node.iter
        case ast.ListComp() | ast.GeneratorExp() | ast.DictComp() if id(node) not in blind:
            yield from (generator.iter for generator in node.generators)
        case ast.Starred() | ast.YieldFrom():
            yield node.value
        case ast.Call(func=ast.Attribute(attr="join")):
            yield from node.args
        case ast.Call() if _calls(node, ORDER_KEEPING):
            yield from node.args
        case _:
            pass


def _is_set(node: ast.expr, names: frozenset[str]) -> bool:
    """Whether `node` is a set as far as one function's text tells."""
    match node:
        case ast.Set() | ast.SetComp():
            return True
        case ast.Name(id=name):
            return name in names
        case ast.Call():
            return _calls(node, frozenset({"set", "frozenset"}))
        case ast.BinOp(op=ast.BitOr() | ast.BitAnd() | ast.Sub() | ast.BitXor()):
            return _is_set(node.left, names) or _is_set(node.right, names)
        case _:
            return False


def _scopes(tree: ast.Module) -> Iterator[tuple[ast.AST, frozenset[str]]]:
    """The module and every function, each with the names that are sets in it."""
    outer = _set_names(tree)
    yield tree, outer
    for node in ast.walk(tree):
        if isinstance(node, Function):
            yield node, _set_names(node)


def _set_names(scope: ast.AST) -> frozenset[str]:
    sets: set[str] = set()
    others: set[str] = set()
    for node in _own_nodes(scope):
        match node:
            case ast.arg(arg=name, annotation=ast.expr() as annotation):
                (sets if _is_set_type(annotation) else others).add(name)
            case ast.AnnAssign(target=ast.Name(id=name), annotation=annotation):
                (sets if _is_set_type(annotation) else others).add(name)
            case ast.Assign(targets=[ast.Name(id=name)], value=value):
                (sets if _is_set(value, frozenset(sets)) else others).add(name)
            case _:
                pass
    return frozenset(sets - others)


def _is_set_type(annotation: ast.expr) -> bool:
    base = annotation.value if isinstance(annotation, ast.Subscript) else annotation
    return _is_name(base, frozenset({"set", "frozenset", "Set", "AbstractSet"}))


def _own_nodes(scope: ast.AST) -> Iterator[ast.AST]:
    """The nodes of one scope, the bodies of functions in it left out."""
    for child in ast.iter_child_nodes(scope):
        if not isinstance(child, Function):
            yield child
            yield from _own_nodes(child)


def _calls(node: ast.AST, names: frozenset[str]) -> TypeGuard[ast.Call]:
    return isinstance(node, ast.Call) and _is_name(node.func, names)


def _is_name(node: ast.AST, names: frozenset[str]) -> bool:
    return isinstance(node, ast.Name) and node.id in names
