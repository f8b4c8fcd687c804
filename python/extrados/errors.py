"""What cannot be done, as exceptions.

```
Error                    anything that extrados refuses
├── BridgeError          a bridge file with mistakes, or an edit that does not fit (also a ValueError)
├── FileError            a file that cannot be read or used (also an OSError)
├── RecordsError         records that cannot be used (also a ValueError)
├── SetupError           an analysis that cannot be made of this bridge (also a RuntimeError)
├── ArgumentError        an argument of a call (also a ValueError and a TypeError)
└── InternalError        a mistake in extrados itself (also a RuntimeError)
Interrupted              Ctrl-C, with what is finished (a KeyboardInterrupt, and no Error)
```

Every :class:`Error` has `findings`, and prints them with line, caret and remedy. Collapse, non-convergence and a bridge that does not stand are
answers with a status, and no errors.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

__all__ = [
    "ArgumentError",
    "BridgeError",
    "Error",
    "FileError",
    "Finding",
    "InternalError",
    "Interrupted",
    "RecordsError",
    "SetupError",
]


@dataclass(frozen=True)
class Finding:
    """Something found in a file or a call."""

    code: str
    """Stable code; `extrados explain CODE` of the command tells more."""
    severity: str
    """"note", "warning" or "error"."""
    message: str
    """What is wrong."""
    file: str | None = None
    """Path of the file; None where it is in no file."""
    line: int | None = None
    """Line, from 1."""
    column: int | None = None
    """Column, from 1."""
    label: str | None = None
    """What stands there."""
    note: str | None = None
    """What else to know."""
    help: str | None = None
    """What to write instead."""
    text: str = ""
    """All of it as people read it, with line and caret."""

    def __str__(self) -> str:
        return self.text.rstrip() or f"{self.severity}[{self.code}]: {self.message}"

    @classmethod
    def of(cls, entry: dict[str, Any]) -> Finding:
        """From an object of the extension module."""
        return cls(**{key: entry[key] for key in cls.__dataclass_fields__ if key in entry})


class Error(Exception):
    """Anything that extrados refuses."""

    findings: tuple[Finding, ...]

    def __init__(self, text: str = "", findings: Sequence[Finding] = ()) -> None:
        super().__init__(text, tuple(findings))
        self.text = text
        self.findings = tuple(findings)

    def __str__(self) -> str:
        return self.text

    @property
    def code(self) -> str | None:
        """Code of the first error, such as "B104"."""
        errors = [one for one in self.findings if one.severity == "error"]
        return errors[0].code if errors else None


class BridgeError(Error, ValueError):
    """A bridge file with mistakes, or an edit that does not fit it.

    >>> import extrados
    >>> try:
    ...     extrados.Bridge.example("tiny").with_(span_1_rise="2.85 GPa")
    ... except extrados.BridgeError as error:
    ...     error.code
    'B104'
    """


class FileError(Error, OSError):
    """A file that cannot be read or used."""


class RecordsError(Error, ValueError):
    """Records that cannot be used."""


class SetupError(Error, RuntimeError):
    """An analysis that cannot be made of this bridge."""


class ArgumentError(Error, ValueError, TypeError):
    """An argument of a call that cannot be used."""


class InternalError(Error, RuntimeError):
    """A mistake in extrados itself: a panic that was caught. The interpreter goes on."""


class Interrupted(KeyboardInterrupt):
    """Ctrl-C, with what is finished. Give `state` as `resume` to the same call, and it goes on where it was."""

    def __init__(self, result: Any = None, state: Any = None) -> None:
        super().__init__("interrupted" + ("; go on with resume=error.state" if state is not None else ""))
        self.result = result
        """What there is of the result, with the status "cancelled"; None where there is none."""
        self.state = state
        """An :class:`extrados.State`, which can be pickled; None where the call keeps none."""

    def __reduce__(self) -> tuple[Any, ...]:
        return Interrupted, (self.result, self.state)


_KINDS: dict[str, type[Error]] = {
    "argument": ArgumentError,
    "bridge": BridgeError,
    "file": FileError,
    "internal": InternalError,
    "records": RecordsError,
    "setup": SetupError,
}


def made(kind: str, findings: list[dict[str, Any]], text: str) -> Error:
    """The exception of a kind, for the extension module."""
    return _KINDS[kind](text, [Finding.of(one) for one in findings])


def argument(message: str, help: str) -> ArgumentError:
    """An argument that cannot be used, by its name."""
    text = f"error[F107]: {message}\n  help: {help}"
    return ArgumentError(text, [Finding("F107", "error", message, help=help, text=text)])


def near(word: str, known: Iterable[str]) -> list[str]:
    """What was meant by a word that is not known, the nearest first: what begins like it, and what is written like it."""
    import difflib

    known = list(known)
    begun = [one for one in known if len(word) > 2 and one.startswith(word)]
    return list(dict.fromkeys([*begun, *difflib.get_close_matches(word, known, n=3)]))[:3]
