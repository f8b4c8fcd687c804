"""A bridge file, and every analysis of it."""

from __future__ import annotations

import functools
import hashlib
import math
import os
import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal, TypeVar, Union, cast

from . import _extrados
from ._extrados import Answer, BlockModel, Project, State
from ._held import same_file
from ._keys import Method
from ._progress import Wanted, told
from ._units import plain
from .errors import BridgeError, Finding, Interrupted, argument, near
from .records import Records, as_files
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
    Update,
    VehicleSweep,
)
from .runs import CollapseRun, PassageRun

__all__ = ["Blocks", "Bridge", "Check", "Quantity"]

Analysis = Literal["load", "thickness", "support-movement"]
Friction = Literal["associated", "non-associated"]
Stage = Literal["update", "service", "collapse", "vehicles", "cases", "support-movement", "sensitivity"]
Value = Union[str, int, float, bool]
"""A value as in a bridge file: "0.6 m", "x1.1" for 1.1 times the file's own, a number where the key has no unit."""


@functools.cache
def program() -> str:
    """Hash of the extension module: another build may compute other bits, and its finished pieces are not taken up."""
    return hashlib.blake2b(Path(_extrados.__file__ or "").read_bytes(), digest_size=16).hexdigest()


@dataclass(frozen=True)
class Quantity:
    """A quantity of a bridge file that can be given another value."""

    path: str
    """Its path, such as "span[1].thickness"."""
    value: str
    """Its value as the file or the default of its key has it."""
    meaning: str
    """What it is."""
    by_default: bool
    """Whether the file leaves it to the default."""

    @property
    def keyword(self) -> str:
        """Its name for :meth:`Bridge.with_`, such as "span_1_thickness"."""
        return _keyword(self.path)


def _keyword(path: str) -> str:
    return path.replace("].", "_").replace("]", "").replace("[", "_").replace(".", "_")


class Check:
    """What was found in a bridge file."""

    def __init__(self, project: Project) -> None:
        self._project = project
        self.findings: tuple[Finding, ...] = tuple(Finding.of(one) for one in project.findings())
        """Errors, doubts and notes, in the order of the file."""
        self.is_usable: bool = project.is_usable()
        """Whether an analysis can be made of it."""

    @property
    def errors(self) -> list[Finding]:
        """What makes the file unusable."""
        return [one for one in self.findings if one.severity == "error"]

    @property
    def warnings(self) -> list[Finding]:
        """What is doubtful."""
        return [one for one in self.findings if one.severity != "error"]

    @property
    def drawing(self) -> Figure:
        """The bridge as its file describes it."""
        return Figure(self._project.drawing())

    def __str__(self) -> str:
        counts = f"{len(self.errors)} errors, {len(self.warnings)} warnings"
        end = f"{self._project.name()}: {counts}; the file can{'' if self.is_usable else 'not'} be used"
        return "\n".join([*(f"{one}\n" for one in self.findings), end])

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Check):
            return NotImplemented
        return self.findings == other.findings and _same_bridge(self._project, other._project)

    def __hash__(self) -> int:
        return hash((self.is_usable, self.findings))

    def __repr__(self) -> str:
        return f"<extrados.Check: {len(self.errors)} errors, {len(self.warnings)} warnings>"

    def _repr_html_(self) -> str:
        from html import escape

        drawing = self.drawing._repr_html_() if self.is_usable else ""
        return f"<pre>{escape(str(self))}</pre>{drawing}"


class Bridge:
    """A bridge file that was read, with what it takes from other files. It does not change; :meth:`with_` gives another.

    A file with mistakes is read as well: :meth:`check` tells them, and every analysis refuses it with a
    :class:`~extrados.BridgeError`.

    >>> import extrados
    >>> bridge = extrados.Bridge.example("tiny")
    >>> thicker = bridge.with_(span_1_thickness="0.45 m")
    >>> more = thicker.collapse(method="limit").last_stable_load_kn_per_m
    >>> more > bridge.collapse(method="limit").last_stable_load_kn_per_m
    True
    """

    __slots__ = ("_known", "_project")

    def __init__(self, project: Project) -> None:
        if isinstance(project, (str, os.PathLike)):
            raise argument(f"Bridge({_short(project)}) cannot be used", "Bridge.read takes the path of a file, Bridge.parse its text")
        self._project = project
        self._known: dict[str, str] | None = None

    # ---- where bridges come from

    @classmethod
    def read(cls, path: str | os.PathLike[str], *, files: Mapping[str, bytes] | None = None) -> Bridge:
        """Reads a bridge file and the files that it names, relative to it. `files` take the place of files of the disk, by path."""
        return cls(Project.read(os.fspath(path), dict(files or {})))

    @classmethod
    def parse(cls, text: str, *, name: str = "bridge.toml", files: Mapping[str, bytes] | None = None) -> Bridge:
        """A bridge from the text of its file. `name` is the path to which other files are relative.

        >>> import extrados
        >>> extrados.Bridge.parse('[bridge]\\nname = 3\\n').check().is_usable
        False
        """
        if not isinstance(text, str):
            raise argument(f"text = {_short(text)} cannot be used", "give the text of a bridge file; Bridge.read takes a path")
        return cls(Project.read(name, {**(files or {}), name: text.encode()}))

    @classmethod
    def new(cls, **sections: Any) -> Bridge:
        """A bridge from the sections of its file: dictionaries, and lists of them for `span`, `cover`, `load` and others of which there are
        several. Values are those of the file, with their units.

        >>> import extrados
        >>> bridge = extrados.Bridge.new(
        ...     bridge={"name": "New", "width": "3.0 m"},
        ...     masonry={"density": "2200 kg/m^3"},
        ...     joint={"friction_angle": "35 deg", "cohesion": "0 kPa"},
        ...     span=[{"profile": "segmental", "span": "4 m", "rise": "1 m", "thickness": "0.35 m", "voussoirs": 21}],
        ...     load=[{"kind": "knife-edge", "force": "10 kN/m", "at": "1/4 of span 1"}],
        ... )
        >>> bridge.name
        'bridge.toml'
        """
        lines = [f"{key} = {_literal(key, value)}" for key, value in sections.items()]
        return cls.parse("\n".join(lines) + "\n")

    @classmethod
    def example(cls, name: str = "bridgemill") -> Bridge:
        """A bridge that comes with the package: see :func:`extrados.examples`."""
        found = _extrados.example(name)
        if found is None:
            raise argument(f"there is no example {_short(name)}", f"there are {', '.join(_extrados.examples_known())}")
        text, files = found
        return cls.parse(text, name=f"{name}.toml", files=dict(files))

    # ---- what it is

    @property
    def name(self) -> str:
        """Path of the file, as it was given."""
        return self._project.name()

    @property
    def text(self) -> str:
        """Text of the file."""
        return self._project.text()

    @property
    def quantities(self) -> list[Quantity]:
        """Everything that can be given another value."""
        rows = self._project.quantities()
        return [Quantity(path, value, meaning, origin == "default") for path, value, meaning, origin in rows]

    @property
    def cases_named(self) -> list[str]:
        """Names of the file's cases."""
        return self._project.case_names()

    def key(self, analysis: str = "", **options: Any) -> str:
        """Hash of everything that the numbers of an analysis follow from: what the file means, the options, and this build. A comment in the
        file does not change it."""
        return self._project.key(analysis, {name: plain(name, value) for name, value in options.items()}, program())

    def __repr__(self) -> str:
        return f"<extrados.Bridge: {self.name}>"

    def _repr_html_(self) -> str:
        return self.check()._repr_html_()

    def __reduce__(self) -> tuple[Any, tuple[str, str, dict[str, bytes]]]:
        return _restored, (self.text, self.name, self._project.files())

    def __copy__(self) -> Bridge:
        return self

    def __deepcopy__(self, memo: Any) -> Bridge:
        return self

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Bridge):
            return NotImplemented
        return self is other or _same_bridge(self._project, other._project)

    def __hash__(self) -> int:
        return hash((self.name, self.text))

    def with_(self, edits: Mapping[str, Any] | None = None, /, **values: Any) -> Bridge:
        """The same bridge with other values, by path or by keyword: `with_({"span[1].thickness": "0.6 m"})` is
        `with_(span_1_thickness="0.6 m")`, `with_({"span[1].thickness [m]": 0.6})`, and with pint `with_(span_1_thickness=0.6 * units.m)`. Units,
        limits and doubts are those of the file.

        >>> import extrados
        >>> bridge = extrados.Bridge.example("tiny")
        >>> bridge.with_({"joint.friction_angle": "30 deg"}, masonry_density="x1.1")
        <extrados.Bridge: tiny.toml>
        """
        paths = {_plain_path(path): (path, value) for path, value in (edits or {}).items()}
        paths |= {(path := self._path(keyword)): (path, value) for keyword, value in values.items()}
        if not paths:
            return self
        made = self._project.edited([f"{path}={_value(*heading)}" for path, heading in paths.items()])
        bridge = Bridge(made)
        # The sections are the same: so are the keywords.
        bridge._known = self._known
        return bridge

    def _keywords(self) -> dict[str, str]:
        if self._known is None:
            self._known = {_keyword(path): path for path, *_ in self._project.quantities()}
        return self._known

    def _path(self, keyword: str) -> str:
        known = self._keywords()
        if keyword in known:
            return known[keyword]
        alike = near(keyword, known)
        meant = f"did you mean {', '.join(alike)}?" if alike else "bridge.quantities lists them"
        text = f"error[B501]: this bridge has no quantity {keyword}\n  help: {meant}; or give its path: with_({{'joint.cohesion': '1 kPa'}})"
        raise BridgeError(text, [Finding("B501", "error", f"no quantity {keyword}", help=meant, text=text)])

    def check(self) -> Check:
        """What is wrong with the file, and what is doubtful; computes nothing."""
        return Check(self._project)

    # ---- analyses

    def collapse(
        self,
        method: Method | None = None,
        *,
        analysis: Analysis | None = None,
        friction: Friction | None = None,
        contact: Literal["points", "distributed"] | None = None,
        contact_length: Literal["fixed", "updated"] | None = None,
        contact_points: str | None = None,
        resolution: str | None = None,
        damping: str | None = None,
        tolerance: float | None = None,
        step_limit: int | None = None,
        progress: Wanted = None,
        resume: State | None = None,
    ) -> Collapse:
        """The load, the thickness or the support movement that makes a mechanism, as the file plans it or as is said here.

        `resolution` is a load such as "1 kN/m", `damping` "local:0.8" and the like. Ctrl-C raises :class:`~extrados.Interrupted`; with its
        state as `resume` a run by discrete elements goes on and ends in the same numbers.
        """
        options = _given(
            method=method,
            analysis=analysis,
            friction=friction,
            contact=contact,
            contact_length=contact_length,
            contact_points=contact_points,
            resolution=resolution,
            damping=damping,
            tolerance=tolerance,
            step_limit=step_limit,
        )
        return _made(Collapse, progress, lambda tell: self._project.collapse(options, tell, resume))

    def sweep(
        self,
        *,
        step: str | None = None,
        method: Literal["limit", "path"] | None = None,
        progress: Wanted = None,
        **options: Any,
    ) -> Sweep | VehicleSweep:
        """The vehicles of the file's `[sweep]` at every position, or its loads where it has none. `step` is the distance between positions,
        such as "0.25 m"; other options are those of :meth:`collapse`."""
        given = _given(step=step, method=method, **options)
        return _made(_swept, progress, lambda tell: self._project.sweep(given, tell))

    def respond(
        self,
        *,
        speed: str | None = None,
        analysis: Literal["static", "transient"] | None = None,
        path: Literal["plain", "condensed"] | None = None,
        progress: Wanted = None,
    ) -> Passage:
        """Displacements, strains and stresses as the train of the file crosses. `speed` is one such as "45 km/h"."""
        given = _given(speed=speed, analysis=analysis, path=path)
        return _made(Passage, progress, lambda tell: self._project.respond(given, tell))

    def update(
        self,
        records: Records = None,
        *,
        search: Literal["modern", "hierarchical", "referee", "gradient", "all"] | None = None,
        variant: str | None = None,
        start: str | None = None,
        records_only: bool = False,
        progress: Wanted = None,
        resume: State | None = None,
    ) -> Update:
        """Parameters of the file from records of a passage: those that it names, or `records`, which :mod:`extrados.records` describes.
        `records_only` judges the records and seeks nothing."""
        project = self._project if records is None else as_files(self, records)
        options = _given(search=search, variant=variant, start=start, records_only=records_only or None)
        return _made(Update, progress, lambda tell: project.update(options, program(), tell, resume))

    def plan_load_test(self) -> dict[str, Any]:
        """What each position and each sensor of the file's `[load_test]` would tell of its `[[parameter]]` tables, before anything is read: `positions` and
        `sensors` in the order in which each adds most, with `information_bit` and `interval_95`, and the same of the whole test."""
        plan = self._project.plan_load_test()
        if plan is None:
            raise argument("the file has no load test to plan", "it needs [load_test] and [[parameter]] tables")
        return plan

    def vary(
        self,
        *ranges: str | Mapping[str, Any],
        grid: bool = False,
        sweep: bool = False,
        outcome: str | None = None,
        most_runs: int = 1000,
        progress: Wanted = None,
        resume: State | None = None,
        **options: Any,
    ) -> Study:
        """The collapse over ranges of quantities: those of the file's `[[vary]]`, or ranges such as "joint.friction_angle=30deg..40deg:5". Ranges are
        given as texts, as dictionaries by path, or by keyword as in :meth:`with_`, with a range or with values: a list, an array, a quantity of pint.
        Numbers of a quantity with a unit have it in the heading: `{"joint.friction_angle [deg]": numpy.linspace(30, 40, 5)}`. Other options are those
        of :meth:`collapse`.

        >>> import extrados
        >>> study = extrados.Bridge.example("tiny").vary("joint.friction_angle=30deg..40deg:3", method="limit")
        >>> study.runs
        4
        >>> study = extrados.Bridge.example("tiny").vary({"joint.friction_angle [deg]": [30, 35]}, span_1_thickness=["0.4 m", "x1.1"], method="limit")
        >>> study.tables["runs"]
        <extrados.Table: 5 rows of 14 columns: run, varied, joint.friction_angle [deg], span[1].thickness [m], status, ... and 6 more>
        """
        known = {name: value for name, value in options.items() if name not in _OF_COLLAPSE and name in self._keywords()}
        options = {name: value for name, value in options.items() if name not in known}
        for name in sorted(options.keys() - _OF_COLLAPSE):
            meant = near(name, [*sorted(_OF_COLLAPSE), *self._keywords()])
            help = f"did you mean {' or '.join(meant)}?" if meant else "arguments are those of collapse; bridge.quantities lists the quantities"
            raise argument(f"there is no argument {name}, and no quantity of this name", help)
        given = _given(
            ranges=[*_ranges(ranges), *_ranges([{self._path(name): value for name, value in known.items()}])] or None,
            grid=grid or None,
            sweep=sweep or None,
            outcome=outcome,
            most_runs=most_runs,
            **options,
        )
        return _made(Study, progress, lambda tell: self._project.vary(given, program(), tell, resume))

    def assess(
        self,
        *,
        skip: Sequence[Stage] = (),
        day: str | None = None,
        progress: Wanted = None,
        resume: State | None = None,
    ) -> Assessment:
        """The bridge against the limits of its file, with a report. `skip` leaves stages out; `day` is the date of the report, such as
        "2026-01-31"."""
        given = _given(skip=list(skip) or None, day=day)
        return _made(Assessment, progress, lambda tell: self._project.assess(given, program(), tell, resume))

    def cases(self, *, progress: Wanted = None, **options: Any) -> Cases:
        """What each named case of the file carries, and which governs; options are those of :meth:`collapse`."""
        return _made(Cases, progress, lambda tell: self._project.cases(_given(**options), tell))

    def compare(self, other: Bridge, *, progress: Wanted = None, **options: Any) -> Comparison:
        """This bridge beside another one: what their files say differently, and what each carries; options are those of :meth:`collapse`."""
        if not isinstance(other, Bridge):
            raise argument(f"other = {_short(other)} cannot be used", "give an extrados.Bridge")
        own, another = self._project, other._project
        return _made(Comparison, progress, lambda tell: own.compare(another, _given(**options), tell))

    def collapse_run(self, **options: Any) -> CollapseRun:
        """A collapse by discrete elements that goes on when it is told to; options are those of :meth:`collapse`."""
        return CollapseRun(self._project, _given(**options))

    def passage_run(
        self,
        *,
        speed: str | None = None,
        analysis: Literal["static", "transient"] | None = None,
        path: Literal["plain", "condensed"] | None = None,
        progress: Wanted = None,
    ) -> PassageRun:
        """A passage that goes on when it is told to."""
        with told(progress) as tell:
            return PassageRun(self._project, _given(speed=speed, analysis=analysis, path=path), tell)


class Blocks:
    """A block model file with its drawing: blocks that are listed or drawn."""

    __slots__ = ("_model",)

    def __init__(self, model: BlockModel) -> None:
        self._model = model

    def __reduce__(self) -> tuple[Any, tuple[BlockModel]]:
        return Blocks, (self._model,)

    def __copy__(self) -> Blocks:
        return self

    def __deepcopy__(self, memo: Any) -> Blocks:
        return self

    def __eq__(self, other: object) -> bool:
        return same_file(self._model, other._model) if isinstance(other, Blocks) else NotImplemented

    def __hash__(self) -> int:
        return hash((self._model.name(), self._model.text()))

    def __repr__(self) -> str:
        return f"<extrados.Blocks: {self._model.name()}>"

    @classmethod
    def read(cls, path: str | os.PathLike[str]) -> Blocks:
        """Reads a block model file and the drawing that it names."""
        return cls(BlockModel.read(os.fspath(path)))

    @classmethod
    def parse(cls, text: str, *, name: str = "blocks.toml", files: Mapping[str, bytes] | None = None) -> Blocks:
        """A block model from the text of its file. `name` is the path to which its drawing is relative, `files` what takes the place of the disk."""
        return cls(BlockModel.read(name, {**(files or {}), name: text.encode()}))

    def collapse(self, *, progress: Wanted = None, resume: State | None = None, **options: Any) -> Collapse:
        """The load that makes a mechanism of the blocks; options are those of :meth:`Bridge.collapse`."""
        return _made(Collapse, progress, lambda tell: self._model.collapse(_given(**options), tell, resume))


_Made = TypeVar("_Made", bound=Result)


def _made(kind: Callable[[Answer], _Made], progress: Wanted, call: Callable[[Any], Answer]) -> _Made:
    """A result of a call that may be watched; what an interruption leaves is a result of the same kind."""
    with told(progress) as tell:
        try:
            return kind(call(tell))
        except Interrupted as error:
            if isinstance(error.result, Answer):
                error.result = kind(error.result)
            raise


def _swept(answer: Answer) -> Sweep | VehicleSweep:
    return VehicleSweep(answer) if answer.is_of_vehicles() else Sweep(answer)


def _same_bridge(one: Project, other: Project) -> bool:
    """Whether two files say the same, and mean the same: what they name may have changed on the disk between the two."""
    if not same_file(one, other):
        return False
    return one.is_usable() == other.is_usable() and (not one.is_usable() or one.key("", {}, "") == other.key("", {}, ""))


def _restored(text: str, name: str, files: dict[str, bytes]) -> Bridge:
    return Bridge.parse(text, name=name, files=files)


def _given(**options: Any) -> dict[str, Any]:
    return {name: plain(name, value) for name, value in options.items() if value is not None}


def _short(value: Any) -> str:
    shape = getattr(value, "shape", None)
    if shape is not None and shape != ():
        return f"{type(value).__name__} of shape {tuple(shape)} and dtype {getattr(value, 'dtype', '?')}"
    text = repr(value)
    return text if len(text) <= 80 else text[:77] + "..."


_OF_COLLAPSE = frozenset(
    ("method", "analysis", "friction", "contact", "contact_length", "contact_points", "resolution", "damping", "tolerance", "step_limit")
)
"""Options of :meth:`Bridge.collapse`, which no quantity has as its keyword."""

_HEADING = re.compile(r"(.*\S)\s+\[([^\[\]]+)\]\s*")
"""A path with a unit, as the columns of tables have it: "joint.friction_angle [deg]"."""


def _plain_path(heading: str) -> str:
    found = _HEADING.fullmatch(heading)
    return found[1] if found else heading


def _ranges(given: Sequence[str | Mapping[str, Any]]) -> list[str]:
    """Ranges as the command has them."""
    found = []
    for one in given:
        if isinstance(one, str):
            found.append(one)
        elif isinstance(one, Mapping):
            found += [f"{_plain_path(heading)}={_spread(heading, values)}" for heading, values in one.items()]
        else:
            raise argument(f"ranges = {_short(one)} cannot be used", 'give "joint.friction_angle=30deg..40deg:5", or {"joint.friction_angle": values}')
    return found


def _spread(name: str, values: Any) -> str:
    """The range or the values of a quantity."""
    if isinstance(values, str):
        return values
    if getattr(values, "shape", None) == () or not isinstance(values, Iterable) or isinstance(values, Mapping):
        values = [values]
    shape = getattr(values, "shape", None)
    if shape is not None and len(shape) != 1:
        raise argument(f"{name} has values of the shape {tuple(shape)}", "give one list of values")
    words = [_value(name, value) for value in values]
    wrong = [word for word in words if "," in word or ".." in word]
    if wrong or not words:
        told = f"{wrong[0]!r} among its values" if wrong else "no values"
        raise argument(f"{name} has {told}", 'give a range such as "30deg..40deg:5" by itself, or a list of values')
    return ",".join(words)


def _scalar(name: str, value: Any) -> Value:
    """A value of Python or NumPy, refused by its name where it is none."""
    value = plain(name, value)
    item = getattr(value, "item", None)
    if item is not None and getattr(value, "shape", None) == ():
        value = item()
    if isinstance(value, float) and not math.isfinite(value):
        raise argument(f"{name} = {value} cannot be used", "give a number that is finite")
    if isinstance(value, (str, bool, int, float)):
        return cast(Value, value)
    raise argument(f"{name} = {_short(value)} cannot be used", 'give one value: a text with its unit such as "0.6 m", or a number')


def _value(name: str, value: Any) -> str:
    value = _scalar(name, value)
    if isinstance(value, bool):
        return "true" if value else "false"
    unit = _HEADING.fullmatch(name)
    if isinstance(value, str):
        return value
    # Steps of an array are told to twelve digits: 0.24 and not 0.24000000000000002.
    told = repr(float(f"{value:.12g}")) if isinstance(value, float) else repr(value)
    return f"{told} {unit[2]}" if unit else told


def _literal(name: str, value: Any) -> str:
    """A value as TOML."""
    if isinstance(value, Mapping):
        inside = ", ".join(f"{_key(key)} = {_literal(f'{name}.{key}', one)}" for key, one in value.items())
        return "{ " + inside + " }"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(_literal(f"{name}[{k}]", one) for k, one in enumerate(value, 1)) + "]"
    value = _scalar(name, value)
    if isinstance(value, str):
        escaped = "".join(_escaped(character) for character in value)
        return f'"{escaped}"'
    return _value(name, value)


def _escaped(character: str) -> str:
    if character in '"\\':
        return "\\" + character
    return f"\\u{ord(character):04x}" if ord(character) < 32 or ord(character) == 127 else character


def _key(key: Any) -> str:
    text = str(key)
    plain = text.replace("_", "").replace("-", "").isalnum() and text.isascii()
    return text if plain else f'"{"".join(_escaped(character) for character in text)}"'

