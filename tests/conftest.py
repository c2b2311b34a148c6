"""What every test runs under: no display, no library path of the machine's own, reproducible Hypothesis."""

from __future__ import annotations

import os
from collections.abc import Iterator

import matplotlib
import pytest
from hypothesis import settings

matplotlib.use("Agg")

settings.register_profile("fixed", derandomize=True, deadline=None)
settings.register_profile("explore", deadline=None, max_examples=1000)
settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "fixed"))


@pytest.fixture(scope="session", autouse=True)
def isolated_environment(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """An empty home and no MODELICAPATH: only the bundled libraries are found."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("HOME", str(tmp_path_factory.mktemp("home")))
        patch.setenv("ACAUSAL_CACHE", str(tmp_path_factory.mktemp("cache")))
        patch.setenv("ACAUSAL_COMPILE", "never")  # no process outlives its test
        patch.delenv("MODELICAPATH", raising=False)
        patch.delenv("XDG_CACHE_HOME", raising=False)
        patch.delenv("ACAUSAL_CACHE", raising=False)
        yield
