"""Looks for texts that the front end does not survive: `python -m tests.fuzz --count 50000`.

Every text must end in a proven flat model or a typed error, within two seconds of CPU time and 1 GiB of
memory. What does not is written to a folder, shortened, to be made a test in `language/found`.
"""

from __future__ import annotations

import argparse
import signal
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from time import process_time

from acausal.api import check_flat
from acausal.errors import AcausalError, Source
from acausal.lang.parser import parse
from acausal.lang.printer import print_definition
from tests.language.models import FEATURES, INVALID, flat_model
from tests.language.mutations import Choices, mutations
from tests.language.sentences import sentence

MOST_SECONDS = 2.0
MOST_MEGABYTES = 1024


_NOISE = ("(" * 300, "{" * 300, "-" * 500, "not " * 500, "'", '"', "/*", "\u00e9")


class TooLong(BaseException):
    """The text takes more than its time."""


@dataclass
class _Alarm:
    """Whether the clock that runs is still to be heard."""

    armed: bool = False


_alarm = _Alarm()


def texts(count: int, seed: str) -> Iterator[str]:
    """Alternately: models of the feature tests with something changed, sentences of a grammar, noise."""
    models = [path.read_text() for path in (*FEATURES, *INVALID)]
    for number in range(count):
        label = f"{seed}:{number}"
        choices = Choices(label)
        model = models[choices.below(len(models))]
        match number % 8:
            case 0 | 1 | 2:
                yield next(mutations(model, label, 1))
            case 3:
                yield model[: choices.below(len(model))] + model[choices.below(len(model)) :]
            case 4:
                yield noise(model, choices)
            case _:
                yield sentence(label)


def noise(model: str, choices: Choices) -> str:
    """A text with some characters replaced, doubled or repeated very often."""
    characters = list(model)
    for _ in range(1 + choices.below(4)):
        place = choices.below(len(characters))
        match choices.below(4):
            case 0:
                characters[place] = chr(choices.below(256))
            case 1:
                characters[place] *= 1 + choices.below(400)
            case 2:
                characters[place] = choices.of(
                    ("(" * 300, "{" * 300, "-" * 500, "not " * 500, "'", '"', "/*", "\u00e9")
                )
            case _:
                characters[place : place + choices.below(40)] = []
    return "".join(characters)


def fault(text: str) -> str | None:
    """What is wrong with how the front end takes a text; None when it behaves."""
    _alarm.armed = True
    signal.setitimer(signal.ITIMER_VIRTUAL, MOST_SECONDS, 0.1)  # again, where the first is swallowed
    try:
        _run(text)
    except AcausalError as error:
        if not all(d.code and d.message for d in error.diagnostics):
            return "an error without a code or message"
        str(error)
    except TooLong:
        _alarm.armed = False
        return f"more than {MOST_SECONDS} s"
    except (Exception, MemoryError) as error:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0)
        return f"{type(error).__name__}: {str(error)[:200]}"
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0)
    return None


def _run(text: str) -> None:
    stored = parse(Source("test.mo", text))
    again = parse(Source("printed.mo", print_definition(stored)))
    assert again == stored, "the printed text is not the same model"
    check_flat(flat_model(text))


def bound_the_process() -> None:
    """Time by a signal, memory by the system."""

    def stop(*_: object) -> None:
        if _alarm.armed:
            raise TooLong

    signal.signal(signal.SIGVTALRM, stop)
    import resource

    resource.setrlimit(resource.RLIMIT_AS, ((MOST_MEGABYTES + 512) * 2**20, resource.RLIM_INFINITY))


def main() -> int:
    """Run; the exit status says whether anything was found."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=50_000)
    parser.add_argument("--seed", default="1")
    parser.add_argument("--out", type=Path, default=Path("out/fuzz"))
    options = parser.parse_args()
    bound_the_process()
    kinds: dict[str, int] = {}
    longest = 0.0
    for number, text in enumerate(texts(options.count, options.seed)):
        start = process_time()
        problem = fault(text)
        longest = max(longest, process_time() - start)
        if problem is None and process_time() - start > MOST_SECONDS:
            problem = f"more than {MOST_SECONDS} s"
        if problem is not None:
            kinds[problem] = kinds.get(problem, 0) + 1
            if kinds[problem] == 1:
                options.out.mkdir(parents=True, exist_ok=True)
                (options.out / f"{options.seed}-{number}.mo").write_text(f"// {problem}\n{text}")
                print(f"{number}: {problem}", flush=True)
        if number % 5000 == 4999:
            print(f"{number + 1} texts, {sum(kinds.values())} faults, longest {longest:.2f} s", flush=True)
    return 1 if kinds else 0


if __name__ == "__main__":
    sys.exit(main())
