"""Results away from the process that computed them: all that one tells, in Python's own objects, so that it can be pickled."""

from __future__ import annotations

import copy
import copyreg
import zlib
from collections.abc import Callable, Iterator
from typing import Any, Union

from ._extrados import Answer, BlockModel, PassageMoment, Project

# Columns of the extension module, by what there are several of. A test holds these names against the module's.
_ONCE = (
    *("path_load", "path_displacement", "path_iterations", "mechanism_translation", "mechanism_rotation"),
    *("particle_centre", "particle_radius", "particle_layer", "hinge_point", "hinge_rotation", "hinge_blocks"),
    *("time", "position", "influence_position", "node", "element", "zone"),
)
_SEVERAL = {
    "blocks": ("outline",),
    "thrust_lines": ("thrust_point", "thrust"),
    "snapshots": (
        *("translation", "rotation", "velocity", "block_stress"),
        *("contact_blocks", "contact_point", "contact_normal", "contact_compression", "contact_shear", "contact_stress", "contact_sliding"),
        *("disc_centre", "disc_angle", "disc_velocity", "disc_stress"),
        *("force_particle", "force_point", "force_normal", "force_compression", "force_shear", "force_sliding"),
    ),
    "channels": ("channel", "influence", "measured", "start", "updated"),
    "moments": ("displacement", "stress", "yielding"),
    "samples": ("sample",),
}
_PAIRS = ("pair_point", "pair_normal", "pair_shear", "pair_opening", "pair_sliding")
_WORDS = ("block_names", "block_roles", "snapshot_loads", "channels", "channel_units", "channel_scales", "moments", "parameters")

Columns = dict[tuple[str, int, int], Any]
"""Arrays by their name, which of several it is, and which joint within."""


class Held:
    """An answer of the extension module that was pickled: it tells what that one told."""

    def __init__(self, told: dict[str, Any], columns: Columns) -> None:
        self._told = told
        self._columns = columns
        for array in columns.values():
            array.flags.writeable = False

    def object(self) -> dict[str, Any]:
        return copy.deepcopy(self._told["object"])

    def number(self, name: str) -> float | None:
        return None

    def status(self) -> str:
        return self._told["object"]["status"]

    def is_of_vehicles(self) -> bool:
        return self._told["is_of_vehicles"]

    def figures(self) -> dict[str, str]:
        return {name: _unpacked(packed) for name, packed in self._told["figures"].items()}

    def figure(self, name: str) -> str | None:
        packed = self._told["figures"].get(name)
        return packed and _unpacked(packed)

    def tables(self) -> dict[str, str]:
        return {name: _unpacked(packed) for name, packed in self._told["tables"].items()}

    def files(self) -> dict[str, bytes]:
        texts = {f"{name}.svg": svg for name, svg in self.figures().items()}
        texts |= {f"{name.replace('_', '-')}.csv": text for name, text in self.tables().items() if text.count("\n") > 1}
        report = self.report()
        return {name: text.encode() for name, text in (texts | ({"report.html": report} if report else {})).items()}

    def report(self) -> str | None:
        packed = self._told["report"]
        return packed and _unpacked(packed)

    def array(self, name: str, at: int = 0, within: int = 0) -> Any:
        return self._columns.get((name, 0 if name in _ONCE else at, within if name in _PAIRS else 0))

    def count(self, name: str) -> int:
        return self._told["counts"].get(name, 0)

    def words(self, name: str) -> list[str]:
        return list(self._told["figures"] if name == "figures" else self._told["words"].get(name, ()))

    def __reduce__(self) -> tuple[Any, ...]:
        return Held, (self._told, self._columns)


class HeldMoment:
    """A moment of a passage in its caller's hands that was pickled."""

    def __init__(self, place: tuple[str, float, float], rows: int, columns: Columns) -> None:
        self._place, self._rows, self._columns = place, rows, columns
        for array in columns.values():
            array.flags.writeable = False

    def place(self) -> tuple[str, float, float]:
        return self._place

    def array(self, name: str, within: int = 0) -> Any:
        return self._columns.get((name, 0, within if name in _PAIRS else 0))

    def rows(self) -> int:
        return self._rows

    def __reduce__(self) -> tuple[Any, ...]:
        return HeldMoment, (self._place, self._rows, self._columns)


Answered = Union[Answer, Held]
Told = Union[PassageMoment, HeldMoment]


def columns(of: Answered) -> Iterator[tuple[tuple[str, int, int], Any]]:
    """All arrays of an answer."""
    places = [(name, 0) for name in _ONCE]
    places += [(name, at) for counted, names in _SEVERAL.items() for at in range(of.count(counted)) for name in names]
    for name, at in places:
        array = of.array(name, at)
        if array is not None:
            yield (name, at, 0), array
    for at in range(of.count("moments")):
        yield from _pairs(at, lambda name, within, at=at: of.array(name, at, within))


def columns_of_moment(of: Told) -> Iterator[tuple[tuple[str, int, int], Any]]:
    """All arrays of a moment."""
    for name in _SEVERAL["moments"]:
        yield (name, 0, 0), of.array(name)
    yield from _pairs(0, of.array)


def _pairs(at: int, array: Callable[[str, int], Any]) -> Iterator[tuple[tuple[str, int, int], Any]]:
    within = 0
    while array(_PAIRS[0], within) is not None:
        for name in _PAIRS:
            yield (name, at, within), array(name, within)
        within += 1


def same_file(one: Project | BlockModel, other: Project | BlockModel) -> bool:
    """Whether two files say the same at the same place, with the same files in memory beside them."""
    return _of_file(one) == _of_file(other)


def same_columns(one: Iterator[tuple[Any, Any]], other: Iterator[tuple[Any, Any]]) -> bool:
    """Whether arrays have the same names, shapes and numbers; what is not a number is the same as itself."""
    import numpy

    rows, others = dict(one), dict(other)
    return rows.keys() == others.keys() and all(
        numpy.array_equal(array, others[key], equal_nan=array.dtype.kind == "f") for key, array in rows.items()
    )


def _copied(all: Iterator[tuple[tuple[str, int, int], Any]]) -> Columns:
    import numpy

    return {key: numpy.array(array) for key, array in all}


def _packed(text: str) -> bytes:
    return zlib.compress(text.encode(), 1)


def _unpacked(packed: bytes) -> str:
    return zlib.decompress(packed).decode()


def _of_answer(answer: Answer) -> tuple[Any, ...]:
    report = answer.report()
    told = {
        "object": answer.object(),
        "is_of_vehicles": answer.is_of_vehicles(),
        "figures": {name: _packed(svg) for name, svg in answer.figures().items()},
        "tables": {name: _packed(text) for name, text in answer.tables().items()},
        "report": report and _packed(report),
        "counts": {name: count for name in _SEVERAL if (count := answer.count(name))},
        "words": {name: words for name in _WORDS if (words := answer.words(name))},
    }
    return Held, (told, _copied(columns(answer)))


def _of_moment(moment: PassageMoment) -> tuple[Any, ...]:
    return HeldMoment, (moment.place(), moment.rows(), _copied(columns_of_moment(moment)))


def _of_file(read: Project | BlockModel) -> tuple[Any, ...]:
    name = read.name()
    how = _read if isinstance(read, Project) else _read_blocks
    return how, (name, {**read.files(), name: read.text().encode()})


def _read(name: str, files: dict[str, bytes]) -> Project:
    return Project.read(name, files)


def _read_blocks(name: str, files: dict[str, bytes]) -> BlockModel:
    return BlockModel.read(name, files)


copyreg.pickle(Answer, _of_answer)
copyreg.pickle(PassageMoment, _of_moment)
copyreg.pickle(Project, _of_file)
copyreg.pickle(BlockModel, _of_file)
