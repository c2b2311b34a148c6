"""The examples of a Markdown page: found, run in order in one folder, and compared with what the page shows.

What a page may contain:

- a Modelica block is a file, named by the comment before it: `<!-- file: Tank.mo -->`. A later block on the
  page has to use that file;
- a Python block runs in the page's own namespace. A text block after it, marked `<!-- output -->`, is what it
  prints;
- a console block holds `$ acausal ...` commands. The lines under a command, if any, are what it prints; `...`
  stands for anything. For `--json`, the keys that are shown have to be there with these values. Where the
  commands are meant to fail, `<!-- exit: 1 -->` comes before the block;
- blocks of `sh` and `text` are not run.
"""

from __future__ import annotations

import contextlib
import doctest
import io
import json
import math
import os
import re
import shlex
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import NoReturn, cast

ROOT = Path(__file__).resolve().parents[2]
RUN = "import sys; from acausal.cli import main; sys.exit(main())"
TIMEOUT = 120

FENCE = re.compile(
    r"^(?P<fence>`{3,})(?P<language>[^\n`]*)\n(?P<code>.*?)^(?P=fence)\s*$", re.MULTILINE | re.DOTALL
)
COMMENT = re.compile(r"<!-- *(?P<key>file|exit|output)(?:: *(?P<value>[^ ]+))? *-->\s*\Z")


@dataclass(frozen=True)
class Block:
    """One fenced block: its first line's number, its language and the comment directly before it."""

    line: int
    language: str
    code: str
    mark: tuple[str, str] | None = None


@dataclass(frozen=True)
class Command:
    """One `$` line of a console block and the text under it."""

    line: int
    arguments: tuple[str, ...]
    expected: str


class ExampleError(AssertionError):
    """An example does not do what its page says."""


def blocks(text: str) -> list[Block]:
    """Every fenced block of a page, in order."""
    return list(_blocks(text))


def _blocks(text: str) -> Iterator[Block]:
    for match in FENCE.finditer(text):
        comment = COMMENT.search(text, 0, match.start())
        mark = (comment["key"], comment["value"] or "") if comment else None
        line = text.count("\n", 0, match.start()) + 2
        yield Block(line, match["language"].strip(), match["code"], mark)


def commands(block: Block) -> list[Command]:
    """The commands of a console block; a line that ends in a backslash goes on."""
    found: list[Command] = []
    for part in re.split(r"^(?=\$ )", block.code, flags=re.MULTILINE):
        if not part.strip():
            continue
        before = block.code.index(part)
        joined = part.replace("\\\n", " ")
        first, _, rest = joined.partition("\n")
        line = block.line + block.code.count("\n", 0, before)
        if not first.startswith("$ acausal"):
            raise ExampleError(f"line {line}: a console block holds `$ acausal` commands, not {first!r}")
        found.append(Command(line, tuple(shlex.split(first)[2:]), rest.strip("\n")))
    return found


def same_text(expected: str, actual: str) -> bool:
    """Whether the texts agree but for space at line ends, `...` standing for anything."""
    want, got = (
        ("\n".join(line.rstrip() for line in text.strip().splitlines()) + "\n") for text in (expected, actual)
    )
    return doctest.OutputChecker().check_output(want, got, doctest.ELLIPSIS)


def same_json(expected: object, actual: object) -> bool:
    """Whether everything that is shown is there; `"..."` stands for any value."""
    if expected == "...":
        return True
    if isinstance(expected, dict):
        want, got = cast("dict[str, object]", expected), cast("dict[str, object]", actual)
        return isinstance(actual, dict) and all(k in got and same_json(v, got[k]) for k, v in want.items())
    if isinstance(expected, list):
        wants, gots = cast("list[object]", expected), cast("list[object]", actual)
        return isinstance(actual, list) and len(wants) == len(gots) and all(map(same_json, wants, gots))
    if isinstance(expected, float):
        return isinstance(actual, float) and math.isclose(actual, expected, rel_tol=1e-3)
    return expected == actual


@dataclass
class Page:
    """A page being run: its folder of files and the namespace of its Python blocks."""

    path: Path
    folder: Path

    def run(self) -> None:
        """Run every block in order."""
        found = blocks(self.path.read_text(encoding="utf-8"))
        self._check_that_files_are_used(found)
        namespace: dict[str, object] = {"__name__": "__main__"}
        printed = ""
        for block in found:
            match block.language:
                case "modelica":
                    self._write(block)
                case "console":
                    self._console(block)
                case "python":
                    printed = self._python(block, namespace)
                case "text" if block.mark == ("output", ""):
                    self._compare(block.line, block.code, printed)
                case "sh" | "text":
                    pass
                case language if language.startswith("{"):
                    pass
                case language:
                    self._fail(block.line, f"no rule how to run a {language or 'nameless'!r} block")

    def _write(self, block: Block) -> None:
        if block.mark is None or block.mark[0] != "file":
            self._fail(block.line, "a Modelica block needs <!-- file: NAME.mo --> before it")
        target = self.folder / block.mark[1]
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(block.code, encoding="utf-8")

    def _python(self, block: Block, namespace: dict[str, object]) -> str:
        code = compile("\n" * (block.line - 1) + block.code, str(self.path), "exec")
        output = io.StringIO()
        with contextlib.chdir(self.folder), contextlib.redirect_stdout(output):
            exec(code, namespace)
        return output.getvalue()

    def _console(self, block: Block) -> None:
        wanted = int(block.mark[1]) if block.mark and block.mark[0] == "exit" else 0
        for command in commands(block):
            done = run_acausal(command.arguments, self.folder)
            if done.returncode != wanted:
                self._fail(
                    command.line, f"exit status {done.returncode}, not {wanted}\n{done.stdout}{done.stderr}"
                )
            if "Traceback" in done.stderr:
                self._fail(command.line, f"a traceback\n{done.stderr}")
            if command.expected and "--json" in command.arguments:
                self._compare_json(command, done.stdout)
            elif command.expected:
                self._compare(command.line, command.expected, done.stdout + done.stderr)

    def _compare(self, line: int, expected: str, actual: str) -> None:
        if not same_text(expected, actual):
            self._fail(line, f"the page shows\n{expected}\nbut this comes out\n{actual}")

    def _compare_json(self, command: Command, actual: str) -> None:
        try:
            same = same_json(json.loads(command.expected), json.loads(actual))
        except json.JSONDecodeError:
            same = False
        if not same:
            self._fail(command.line, f"the page shows\n{command.expected}\nbut this comes out\n{actual}")

    def _check_that_files_are_used(self, found: list[Block]) -> None:
        for number, block in enumerate(found):
            if block.mark and block.mark[0] == "file":
                later = [b.code for b in found[number + 1 :] if b.language in {"python", "console"}]
                if not any(block.mark[1] in code for code in later):
                    self._fail(block.line, f"nothing on the page uses {block.mark[1]}")

    def _fail(self, line: int, message: str) -> NoReturn:
        raise ExampleError(f"{self.path.relative_to(ROOT)}:{line}: {message}")


def run_acausal(arguments: tuple[str, ...], folder: Path) -> subprocess.CompletedProcess[str]:
    """Run the command line as the installed script does, in `folder`."""
    path = os.pathsep.join(filter(None, (str(ROOT), os.environ.get("PYTHONPATH"))))
    return subprocess.run(
        [sys.executable, "-c", RUN, *arguments],
        cwd=folder,
        env=os.environ | {"PYTHONPATH": path, "COLUMNS": "100", "NO_COLOR": "1", "MPLBACKEND": "Agg"},
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        timeout=TIMEOUT,
        check=False,
    )
