"""Files: which ones may be read, tables in them, and MSL's ModelicaInternal functions that only read.

A model may read files below the library path and below its own folder, and nothing else; it may write none.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import cast

from acausal.externals.arguments import (
    Argument,
    Changed,
    Routine,
    RoutineFailed,
    Tensor,
    text,
    whole,
)

MAX_BYTES = 200_000_000
_URI = re.compile(r"modelica:/{0,2}(?P<package>[A-Za-z_][\w.]*)/?(?P<rest>.*)", re.DOTALL)
_FILE_TYPES = {"none": 1, "file": 2, "directory": 3}
Rows = list[list[float]]


@dataclass(frozen=True)
class Files:
    """What a model may read: files below `roots`; names are relative to `base`.

    `folder_of` gives the folder of a package for `modelica://Package/...`, None for an unknown one.
    """

    roots: tuple[Path, ...]
    base: Path
    folder_of: Callable[[str], Path | None]

    def path(self, name: str) -> Path:
        """The absolute path of a name or URI; it need not exist or be readable."""
        found = _URI.fullmatch(name)
        if found is not None:
            folder = self.folder_of(found["package"])
            if folder is None:
                raise RoutineFailed(f"the package of `{name}` is not found")
            return (folder / found["rest"].lstrip("/")).absolute()
        plain = name.removeprefix("file://")
        if "://" in plain or "\0" in plain:
            raise RoutineFailed(f"`{name}` is not the name of a file")
        return Path(self.base, plain).absolute()

    def readable(self, name: str) -> Path:
        """The path of a file that may be read. Raises `RoutineFailed`."""
        path = self.path(name).resolve()
        if not any(path.is_relative_to(root.resolve()) for root in self.roots):
            message = f"the file `{name}` is neither below the library path nor below the model's folder"
            raise RoutineFailed(f"{message}, so it is not read")
        if not path.is_file():
            raise RoutineFailed(f"there is no file `{name}`")
        if path.stat().st_size > MAX_BYTES:
            raise RoutineFailed(f"the file `{name}` is larger than {MAX_BYTES // 1_000_000} MB")
        return path

    def read(self, name: str) -> str:
        """The text of a file. Raises `RoutineFailed`."""
        try:
            return self.readable(name).read_bytes().decode("utf-8-sig", errors="replace")
        except OSError as problem:
            raise RoutineFailed(f"the file `{name}` cannot be read: {problem.strerror}") from None


# ------------------------------------------------------------------------------ tables


def read_table(files: Files, name: str, table: str, delimiter: str = ",", header: int = 0) -> Rows:
    """The matrix `table` of a text, CSV or MATLAB file (by its extension). Raises `RoutineFailed`."""
    lower = name.lower()
    if lower.endswith(".mat"):
        found = _matlab(files.readable(name), name).get(table)
        if found is None:
            raise RoutineFailed(f"there is no matrix `{table}` in the file `{name}`")
        return found
    if lower.endswith(".csv"):
        return _comma_separated(files.read(name), name, delimiter, header)
    return _text_table(files.read(name), name, table)


def _matlab(path: Path, name: str) -> dict[str, Rows]:
    import numpy as np  # late: few models need it
    from scipy.io import loadmat

    try:
        content: dict[str, object] = loadmat(path, mat_dtype=True)
    except (ValueError, TypeError, NotImplementedError, OSError, EOFError) as problem:
        raise RoutineFailed(f"`{name}` is not a MATLAB file of version 4, 6 or 7: {problem}") from None
    matrices: dict[str, Rows] = {}
    pending = list(content.items())
    while pending:
        key, value = pending.pop()
        if not isinstance(value, np.ndarray):
            continue
        array = cast("np.ndarray[tuple[int, ...], np.dtype[np.void]]", value)
        if array.ndim == 2 and array.dtype.names is not None and array.size == 1:  # a structure: `s.tab`
            pending += [(f"{key}.{name}", array[name][0, 0]) for name in array.dtype.names]
        elif array.ndim == 2 and array.dtype.kind in "fiub":
            matrices[key] = array.astype(float).tolist()
    return matrices


def _comma_separated(content: str, name: str, delimiter: str, header: int) -> Rows:
    rows: list[list[float]] = []
    for number, line in enumerate(content.splitlines()[header:], start=header + 1):
        cells = [cell.strip() for cell in line.split(delimiter or ",")]
        if not line.strip():
            continue
        try:
            rows.append([float(cell) for cell in cells if cell])
        except ValueError:
            raise RoutineFailed(f"line {number} of `{name}` holds something that is not a number") from None
        if len(rows[-1]) != len(rows[0]):
            raise RoutineFailed(f"line {number} of `{name}` has {len(rows[-1])} columns, not {len(rows[0])}")
    if not rows:
        raise RoutineFailed(f"there are no numbers in `{name}`")
    return rows


_HEAD = re.compile(
    r"^[ \t]*(?:double|float)[ \t]+([^\s,()]+)[ \t]*\([ \t]*(\d+)[ \t]*,[ \t]*(\d+)[ \t]*\)", re.MULTILINE
)


def _text_table(content: str, name: str, table: str) -> Rows:
    """`#1`, then `double table(rows, columns)` and the elements row by row; `#` starts a comment."""
    if not content.startswith("#1"):
        raise RoutineFailed(f"the file `{name}` is no table: its first characters are not `#1`")
    bare = re.sub(r"#[^\n]*", "", content)
    heads = list(_HEAD.finditer(bare))
    for head, after in zip(heads, [*[h.start() for h in heads[1:]], len(bare)], strict=True):
        if head[1] != table:
            continue
        rows, columns = int(head[2]), int(head[3])
        cells = re.split(r"[\s,;]+", bare[head.end() : after].strip(" \t\r\n,;"))
        if len(cells) < rows * columns:
            raise RoutineFailed(
                f"`{table}` in `{name}` has {len(cells)} elements, not {rows} times {columns}"
            )
        try:
            values = [float(cell) for cell in cells[: rows * columns]]
            return [values[i * columns : (i + 1) * columns] for i in range(rows)]
        except ValueError:
            raise RoutineFailed(f"`{table}` in `{name}` holds something that is not a number") from None
    known = ", ".join(head[1] for head in heads)
    raise RoutineFailed(f"there is no table `{table}` in the file `{name}`, which holds: {known or 'none'}")


# ------------------------------------------------------------------------------ functions


def file_routines(files: Files) -> dict[str, Routine]:
    """MSL's functions of files and of the system, as far as they only read."""

    def full_path(args: Sequence[Argument]) -> Changed:
        return {-1: str(files.path(text(args[0])))}

    def stat(args: Sequence[Argument]) -> Changed:
        path = files.path(text(args[0]))
        if not any(path.resolve().is_relative_to(root.resolve()) for root in files.roots):
            return {-1: _FILE_TYPES["none"]}
        return {-1: _FILE_TYPES["file" if path.is_file() else "directory" if path.is_dir() else "none"]}

    def folder(args: Sequence[Argument]) -> Changed:
        return {-1: str(files.base)}

    def lines(args: Sequence[Argument]) -> Changed:
        return {-1: len(files.read(text(args[0])).splitlines())}

    def line(args: Sequence[Argument]) -> Changed:
        """(file, number, end of file): a line, counted from 1."""
        content, number = files.read(text(args[0])).splitlines(), whole(args[1])
        inside = 1 <= number <= len(content)
        return {-1: content[number - 1] if inside else "", 2: not inside}

    def all_lines(args: Sequence[Argument]) -> Changed:
        """(file, lines, how many)."""
        content = files.read(text(args[0])).splitlines()[: whole(args[2])]
        return {1: Tensor((len(content),), tuple(content))}

    def matrix_sizes(args: Sequence[Argument]) -> Changed:
        """(file, matrix, sizes)."""
        rows = read_table(files, text(args[0]), text(args[1]))
        return {2: Tensor((2,), (len(rows), len(rows[0])))}

    def real_matrix(args: Sequence[Argument]) -> Changed:
        """(file, matrix, elements, rows, columns, verbose)."""
        rows = read_table(files, text(args[0]), text(args[1]))
        return {2: Tensor((len(rows), len(rows[0])), tuple([cell for row in rows for cell in row]))}

    return {
        "ModelicaInternal_fullPathName": full_path,
        "ModelicaInternal_stat": stat,
        "ModelicaInternal_getcwd": folder,
        "ModelicaInternal_countLines": lines,
        "ModelicaInternal_readLine": line,
        "ModelicaInternal_readFile": all_lines,
        "ModelicaIO_readMatrixSizes": matrix_sizes,
        "ModelicaIO_readRealMatrix": real_matrix,
        **_SYSTEM,
    }


def _nothing(args: Sequence[Argument]) -> Changed:
    return {}


def _time(args: Sequence[Argument]) -> Changed:
    """(ms, s, min, h, day, month, year): always the start of 2000, so that runs repeat."""
    return dict(enumerate((0, 0, 0, 0, 1, 1, 2000)))


def _environment(args: Sequence[Argument]) -> Changed:
    """(name, convert, content, exists): a model sees an empty environment."""
    return {2: "", 3: False}


def _process(args: Sequence[Argument]) -> Changed:
    return {-1: 1}


_SYSTEM: dict[str, Routine] = {
    "ModelicaInternal_print": _nothing,
    "ModelicaMessage": _nothing,
    "ModelicaStreams_closeFile": _nothing,
    "ModelicaInternal_getTime": _time,
    "ModelicaInternal_getenv": _environment,
    "ModelicaInternal_getpid": _process,
}
"""Harmless calls of the system; what they give does not depend on the machine."""
