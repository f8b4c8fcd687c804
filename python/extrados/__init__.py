"""Masonry arch bridges from one bridge file: collapse, service response, updating, assessment.

>>> import extrados
>>> bridge = extrados.Bridge.example("bridgemill")
>>> found = bridge.collapse(method="limit")
>>> round(found.last_stable_load_kn_per_m, 1)
219.4

In a notebook, `found.figure("mechanism")` draws how the bridge fails. Numbers are those of the command `extrados`, to the last bit.
"""

from __future__ import annotations

from importlib import import_module
from typing import Any

from . import errors, records, results, runs
from ._extrados import State, examples_known, threads, version
from ._progress import Progress
from .bridge import Blocks, Bridge, Check, Quantity
from .errors import (
    ArgumentError,
    BridgeError,
    Error,
    FileError,
    Finding,
    InternalError,
    Interrupted,
    RecordsError,
    SetupError,
)
from .results import (
    Assessment,
    Cases,
    Collapse,
    Comparison,
    Figure,
    Passage,
    Result,
    Study,
    Sweep,
    Table,
    Update,
    VehicleSweep,
)
from .runs import CollapseRun, PassageRun

__version__ = version()


def __getattr__(name: str) -> Any:
    """Modules that need more than NumPy are brought in where they are asked for."""
    if name in ("cluster", "umbridge"):
        return import_module(f"extrados.{name}")
    raise AttributeError(f"module 'extrados' has no attribute {name!r}")


def examples() -> list[str]:
    """Names of the bridges that come with the package, for :meth:`Bridge.example`.

    >>> import extrados
    >>> "tiny" in extrados.examples()
    True
    """
    return examples_known()


__all__ = [
    "ArgumentError",
    "Assessment",
    "Blocks",
    "Bridge",
    "BridgeError",
    "Cases",
    "Check",
    "Collapse",
    "CollapseRun",
    "Comparison",
    "Error",
    "Figure",
    "FileError",
    "Finding",
    "InternalError",
    "Interrupted",
    "Passage",
    "PassageRun",
    "Progress",
    "Quantity",
    "RecordsError",
    "Result",
    "SetupError",
    "State",
    "Study",
    "Sweep",
    "Table",
    "Update",
    "VehicleSweep",
    "errors",
    "examples",
    "records",
    "results",
    "runs",
    "threads",
]
