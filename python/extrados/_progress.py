"""How far a call is: a callback of the user's, or a bar in terminal and notebook."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any, Union

from .errors import argument


@dataclass(frozen=True)
class Progress:
    """How far a call is."""

    part: str
    """Part of the work, such as a stage of an assessment; empty where there is one only."""
    stage: str
    """What it does just now, in words."""
    fraction: float | None
    """How much of it is done, from 0 to 1; None where that is not known."""
    steps: int
    """Steps or iterations so far; 0 where they are not counted."""


Wanted = Union[bool, None, Callable[[Progress], Any]]
"""True for a bar, a function for your own, None or False for silence."""

_Told = Callable[[str, str, Union[float, None], int], None]


class _Line:
    """A line on stderr that is written over, where tqdm is not installed."""

    def __init__(self) -> None:
        self.width, self.last = 0, 0.0

    def show(self, progress: Progress) -> None:
        if time.monotonic() - self.last < 0.1:
            return
        self.last = time.monotonic()
        share = "" if progress.fraction is None else f"{100 * progress.fraction:3.0f} % "
        line = f"{share}{progress.part} {progress.stage}"[:100]
        sys.stderr.write("\r" + line.ljust(self.width))
        sys.stderr.flush()
        self.width = max(self.width, len(line))

    def close(self) -> None:
        if self.width:
            sys.stderr.write("\r" + " " * self.width + "\r")
            sys.stderr.flush()


class _Bar:
    """A bar of tqdm, which knows terminals and notebooks."""

    def __init__(self, tqdm: Any) -> None:
        self.bar = tqdm(total=1000, leave=False, bar_format="{percentage:3.0f}% |{bar}| {elapsed}<{remaining} {desc}")

    def show(self, progress: Progress) -> None:
        self.bar.set_description_str(f"{progress.part} {progress.stage}"[:80].strip(), refresh=False)
        if progress.fraction is not None:
            self.bar.n = int(1000 * min(max(progress.fraction, 0.0), 1.0))
        self.bar.refresh()

    def close(self) -> None:
        self.bar.close()


@contextmanager
def told(wanted: Wanted) -> Iterator[_Told | None]:
    """What the extension module calls while it works."""
    if wanted is None or wanted is False:
        yield None
        return
    if wanted is True:
        try:
            from tqdm.auto import tqdm
        except ImportError:
            shown: _Line | _Bar = _Line()
        else:
            shown = _Bar(tqdm)
        try:
            yield lambda part, stage, fraction, steps: shown.show(Progress(part, stage, fraction, steps))
        finally:
            shown.close()
        return
    if not callable(wanted):
        raise argument(f"progress = {wanted!r} cannot be used", "give True, or a function of one extrados.Progress")
    yield lambda part, stage, fraction, steps: wanted(Progress(part, stage, fraction, steps)) and None
