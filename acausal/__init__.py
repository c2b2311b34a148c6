"""A Modelica compiler: text in, a causalised system that can be run and looked at out.

>>> import acausal
>>> decay = acausal.loads("model Decay Real x(start = 1, fixed = true); equation der(x) = -x; end Decay;")
>>> decay.compile().states
('x',)

What is public is imported when it is first asked for, so that `import acausal` costs nothing.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

from acausal.version import __version__

if TYPE_CHECKING:
    from acausal.api import CompiledModel, Model, load, loads
    from acausal.errors import AcausalError
    from acausal.export.casadi_model import load_casadi
    from acausal.notebook import load_ipython_extension
    from acausal.results.stored import read_result
    from acausal.simulate.result import Result

__all__ = [
    "AcausalError",
    "CompiledModel",
    "Model",
    "Result",
    "__version__",
    "load",
    "load_casadi",
    "load_ipython_extension",
    "loads",
    "read_result",
]

_HOMES = {
    "AcausalError": "acausal.errors",
    "CompiledModel": "acausal.api",
    "Model": "acausal.api",
    "Result": "acausal.simulate.result",
    "load": "acausal.api",
    "load_casadi": "acausal.export.casadi_model",
    "load_ipython_extension": "acausal.notebook",
    "loads": "acausal.api",
    "read_result": "acausal.results.stored",
}


def __getattr__(name: str) -> Any:
    home = _HOMES.get(name)
    if home is None:
        raise AttributeError(f"module 'acausal' has no attribute '{name}'")
    value = getattr(import_module(home), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
