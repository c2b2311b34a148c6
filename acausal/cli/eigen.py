"""`acausal eigen`."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

from acausal.analysis.compare import comparison_json
from acausal.analysis.linearize import At, snapshots
from acausal.analysis.snapshot import Snapshot
from acausal.analysis.stored import stored_snapshots
from acausal.analysis.sweep import Locus, spaced, sweep, table_of, variants_json
from acausal.api import CompiledModel
from acausal.cli.commands import Target
from acausal.cli.eigen_text import print_comparison, print_locus, print_snapshot, print_variants, titles
from acausal.cli.output import check_writable, print_diagnostics, print_json, print_text
from acausal.errors import Diagnostic, UsageProblem, fail
from acausal.study.metrics.table import read_table

_PICTURES = (".png", ".svg", ".pdf", ".html")


@dataclass(frozen=True)
class Request:
    """The settings of `acausal eigen`, as they were typed."""

    at: tuple[str, ...]
    everything: bool = False
    result: Path | None = None
    compare: str | None = None
    sweep: str | None = None
    variants: Path | None = None
    plot: Path | None = None
    mode: int | None = None
    animate: int | None = None

    @property
    def instants(self) -> tuple[At, ...]:
        """What `--at` lists. Raises `UsageProblem` for what is neither a word nor seconds."""
        texts = [part.strip() for text in self.at for part in text.split(",")]
        return tuple(_instant(text) for text in texts)

    def verify(self) -> None:
        """Raises `UsageProblem` for settings that do not go together, before anything is compiled."""
        kinds = ("compare", "sweep", "variants", "result")
        several = [f"--{kind}" for kind in kinds if getattr(self, kind) is not None]
        if len(several) > 1:
            raise _wrong(f"{' and '.join(several)} do not go together")
        if (self.sweep is not None or self.variants is not None) and len(self.instants) > 1:
            raise _wrong("--sweep and --variants are about one instant")
        if (self.mode is not None or self.animate is not None) and self.plot is None:
            raise _wrong("--mode and --animate-mode need a file to draw to: --plot FILE")
        if self.plot is not None:
            known = (".gif", ".html") if self.animate is not None else _PICTURES
            if self.plot.suffix.lower() not in known:
                hint = f"end the name in {', '.join(known)}"
                raise fail(UsageProblem, "usage.plot", f"`{self.plot}` cannot be drawn", hint=hint)
        check_writable(self.plot)


def _wrong(problem: str) -> Exception:
    return fail(UsageProblem, "usage.eigen", problem)


def _instant(text: str) -> At:
    try:
        return text if text in ("initial", "steady") or text.startswith("steady@") else float(text)
    except ValueError:
        hint = "give `initial`, `steady`, seconds or `steady@SECONDS`, several separated by commas"
        raise fail(UsageProblem, "usage.at", f"`--at {text}` is no instant", hint=hint) from None


def run_eigen(target: Target, request: Request, *, as_json: bool) -> None:
    """Compile, linearise at every instant, print, draw. What cannot work is refused first."""
    request.verify()
    compiled = CompiledModel(target.run())
    print_diagnostics(compiled.warnings)
    if request.sweep is not None:
        _sweep(compiled, request, request.sweep, as_json)
    elif request.variants is not None:
        _variants(compiled, request, request.variants, as_json)
    else:
        _snapshots(compiled, target, request, as_json)
    if request.plot is not None and not as_json:
        print_text(f"wrote {request.plot}")


def _snapshots(compiled: CompiledModel, target: Target, request: Request, as_json: bool) -> None:
    if request.result is not None:
        found = stored_snapshots(compiled.code, read_table(request.result).columns, request.instants)
    else:
        found = snapshots(compiled.code, request.instants)
    others: tuple[Snapshot, ...] = ()
    if request.compare is not None:
        second = CompiledModel(replace(target, model=request.compare, class_name=None, assignments=()).run())
        print_diagnostics(second.warnings)
        others = snapshots(second.code, request.instants)
    for snapshot in (*found, *others):
        print_diagnostics(warnings(snapshot))
    if request.plot is not None:
        _draw((*found, *others), request, request.plot)
    if as_json:
        objects = [snapshot.to_json() for snapshot in found]
        for one, other, json in zip(found, others, objects, strict=False):
            json["compare"] = comparison_json(one, other)
        print_json(objects[0] if len(objects) == 1 else objects)
        return
    for number, snapshot in enumerate(found):
        if number:
            print_text("")
        print_snapshot(snapshot, request.everything)
        if others:
            print_comparison(snapshot, others[number])


def _sweep(compiled: CompiledModel, request: Request, text: str, as_json: bool) -> None:
    name, values = spaced(text)
    locus = sweep(compiled.code, name, values, request.instants[0])
    if request.plot is not None:
        _draw_locus(locus, request.plot)
    if as_json:
        print_json(locus.to_json())
    else:
        print_locus(locus, request.everything)


def _variants(compiled: CompiledModel, request: Request, table: Path, as_json: bool) -> None:
    found = compiled.variants(table_of(table), request.instants[0])
    if request.plot is not None:
        from acausal.analysis.drawing import draw_cloud

        if request.plot.suffix.lower() == ".html":
            raise _wrong("--variants draws PNG, SVG or PDF")
        draw_cloud(found, request.plot)
    if as_json:
        print_json({"model": compiled.name, "at": request.at[0], "variants": variants_json(found)})
    else:
        print_variants(found, request.everything)


def warnings(snapshot: Snapshot) -> list[Diagnostic]:
    """What the snapshot says of itself, as warnings."""
    where = f"{'in the steady state ' if snapshot.at == 'steady' else ''}at {snapshot.time:g} s"
    return [
        Diagnostic("eigen.snapshot", f"{snapshot.model} {where}: {text}", severity="warning")
        for text in snapshot.warnings
    ]


def _draw(found: tuple[Snapshot, ...], request: Request, path: Path) -> None:
    number = request.animate if request.animate is not None else request.mode
    if number is not None and not 1 <= number <= len(found[0].modes.modes):
        raise _wrong(f"there is no mode {number}: the table numbers them from 1")
    if path.suffix.lower() == ".html":
        from acausal.analysis.page import page

        title = " and ".join(dict.fromkeys(snapshot.model for snapshot in found))
        _write(path, page(f"{title}: eigenvalues", found, titles(found), chosen=number))
    elif request.animate is not None:
        from acausal.analysis.animation import animate

        animate(found[0], request.animate - 1, path)
    elif request.mode is not None:
        found[0].plot_shape(request.mode - 1, path)
    else:
        from acausal.analysis.drawing import draw_plane

        draw_plane(found, path, titles(found))


def _draw_locus(locus: Locus, path: Path) -> None:
    if path.suffix.lower() != ".html":
        locus.plot(path)
        return
    from acausal.analysis.page import page

    tracks = [list(zip(b.real.tolist(), b.imag.tolist(), strict=True)) for b in locus.roots.T]
    tracks = [track for track in tracks if max(y for _, y in track) >= 0]
    first, last = locus.snapshot(0), locus.snapshot(-1)
    ends = locus.values[0], locus.values[-1]
    names = [f"{locus.name} = {value:g} {locus.unit}".strip() for value in ends]
    _write(path, page(f"{first.model} over {locus.name}", (first, last), names, tracks))


def _write(path: Path, text: str) -> None:
    try:
        path.write_text(text, encoding="utf-8")
    except OSError as problem:
        what = f"cannot write `{path}`: {problem.strerror or problem}"
        raise fail(UsageProblem, "usage.output", what) from None
