"""Results. Numbers have the names that they have in the command's `result.json`, with the unit at the end; columns are NumPy arrays in SI
units that look into the result's memory.
"""

from __future__ import annotations

import csv
import importlib
import io
import json
import os
import re
from collections.abc import Iterator, Mapping, Sequence
from html import escape, unescape
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, TypeVar, cast

from . import _extrados, _keys
from ._held import Answered, Told, columns, same_columns
from .errors import argument, near

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt
    from matplotlib.axes import Axes

    Numbers = npt.NDArray[np.float64]
    Counts = npt.NDArray[np.uint64]
    Flags = npt.NDArray[np.bool_]

__all__ = [
    "Assessment",
    "Cases",
    "Channel",
    "Collapse",
    "Comparison",
    "Figure",
    "Moment",
    "Passage",
    "Result",
    "Snapshot",
    "Study",
    "Sweep",
    "Table",
    "Update",
    "VehicleSweep",
]


def _column(name: str, about: str) -> Any:
    """A column that looks into what its owner holds, by its name there."""
    return property(lambda owner: owner._array(name), doc=about)


class Figure(str):
    """A drawing as SVG: a text that notebooks show as a picture."""

    __slots__ = ()

    def __repr__(self) -> str:
        sides = re.search(r'width="([\d.]+)mm" height="([\d.]+)mm"', self)
        size = f"{sides[1]} mm x {sides[2]} mm" if sides else f"{len(self)} characters"
        titles = [unescape(words) for words in re.findall(r"<text[^>]*>([^<]+)</text>", self)[:2]]
        return f"<extrados.Figure: {'; '.join([size, *titles])}>"

    def _repr_html_(self) -> str:
        # Within a page there is no declaration of XML, and the drawing is as wide as there is room.
        return f'<div style="max-width:720px;background:#fff">{self[self.find("<svg"):]}</div>'

    def _repr_svg_(self) -> str:
        return str(self)

    def save(self, path: str | os.PathLike[str], *, width_px: int | None = None) -> Path:
        """Writes the drawing to a file, and gives its path. The end of its name says as what: ".svg", ".png" (`width_px` pixels wide, 2400 where
        nothing is said) or ".pdf", by matplotlib where it is installed."""
        path = Path(path)
        suffix = path.suffix.lower()
        if suffix not in (".svg", ".png", ".pdf"):
            told = f"drawings are not written as {suffix!r}" if suffix else "its name does not say as what"
            raise argument(f"path = {str(path)!r} cannot be used: {told}", 'end the name with ".svg", ".png" or ".pdf"')
        if width_px is not None and suffix != ".png":
            raise argument(f"width_px = {width_px} cannot be used for a file {suffix!r}", 'leave it out, or end the name with ".png"')
        if suffix == ".svg":
            path.write_text(self, encoding="utf-8", newline="\n")
        elif suffix == ".png":
            path.write_bytes(_extrados.png(self, _pixels(width_px)))
        else:
            from ._pdf import written

            path.write_bytes(written(self))
        return path


class Table(str):
    """A table as CSV, with units in the names of its columns."""

    __slots__ = ()

    def __repr__(self) -> str:
        names = next(csv.reader(io.StringIO(self)), [])
        shown = [*names[:8], f"and {len(names) - 8} more"] if len(names) > 9 else names
        return f"<extrados.Table: {self.count(chr(10)) - 1} rows of {len(names)} columns: {', '.join(shown)}>"


def _pixels(wanted: Any) -> int:
    if wanted is None:
        return _extrados.png_width()
    if isinstance(wanted, bool) or not hasattr(wanted, "__index__") or not 0 <= wanted.__index__() < 2**32:
        raise argument(f"width_px = {wanted!r} cannot be used", "give a whole number of pixels, 1 to 20000")
    return wanted.__index__()


_OF_THE_CALL = ("wall_seconds", "seconds", "threads", "version", "runs_from_cache", "evaluations_taken_up")
"""Fields that tell how a call went, and not what it found."""


def _found(value: Any) -> Any:
    """What was found, without how the call went."""
    if isinstance(value, dict):
        return {key: _found(one) for key, one in value.items() if key not in _OF_THE_CALL}
    return [_found(one) for one in value] if isinstance(value, list) else value


_What = TypeVar("_What")


class _Named(dict[str, _What]):
    """Things by their names; one that is not there is answered with what is."""

    def __init__(self, things: Mapping[str, _What], what: str) -> None:
        super().__init__(things)
        self._what = what

    def __missing__(self, name: str) -> _What:
        meant = near(str(name), self)
        told = f"did you mean {' or '.join(map(repr, meant))}?" if meant else f"it has {', '.join(self) or 'none'}"
        raise KeyError(f"this result has no {self._what} {name!r}; {told}")

    def __reduce__(self) -> tuple[Any, ...]:
        return dict, (dict(self),)


class _Part:
    """A part of a result. It does not change: copies look into the same result."""

    def __copy__(self) -> Any:
        copied = object.__new__(type(self))
        copied.__dict__.update(self.__dict__)
        return copied

    def __deepcopy__(self, memo: Any) -> Any:
        return self.__copy__()


class Result:
    """What an analysis found. Every field of the command's `result.json` is an attribute of the same name.

    Results can be pickled and copied. Two are equal where they found the same to the last bit, however long that took.
    """

    status: str
    """How the analysis ended: "collapsed", "completed", "not-converged" and so on; `extrados explain STATUS` tells more."""
    warnings: list[dict[str, Any]]
    """What a reader should look at: objects with `code` and `message`, and a place where they come from a file."""
    assumptions: list[str]
    """What the result rests on, in words."""
    wall_seconds: float
    """How long the call took [s]."""
    threads: int
    """On how many threads."""
    version: str
    """Version of the program, and in a release its commit."""
    schema: str
    """Name and version of the object."""
    bridge: str
    """Name of the bridge."""

    _main: tuple[str, ...] = ()
    _shown: tuple[str, ...] = ("status",)

    def __init__(self, answer: Answered) -> None:
        self._answer = answer
        self._object: dict[str, Any] | None = None

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self._answer,)

    def __copy__(self) -> Any:
        return type(self)(self._answer)

    def __deepcopy__(self, memo: Any) -> Any:
        return self.__copy__()

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Result) or type(self) is not type(other):
            return NotImplemented
        if self._answer is other._answer:
            return True
        return (
            _found(self._answer.object()) == _found(other._answer.object())
            and self._answer.tables() == other._answer.tables()
            and same_columns(columns(self._answer), columns(other._answer))
        )

    def __hash__(self) -> int:
        shown = (getattr(self, name) for name in self._shown if name not in _OF_THE_CALL)
        return hash((type(self).__name__, *shown))

    def _whole(self) -> dict[str, Any]:
        if self._object is None:
            self._object = self._answer.object()
        return self._object

    def _array(self, name: str) -> Any:
        return self._answer.array(name)

    # Unknown names are mistakes for the type checker: every field is declared.
    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> Any:
            if name.startswith("_"):
                raise AttributeError(name)
            number = self._answer.number(name)
            if number is not None:
                return number
            try:
                return self._whole()[name]
            except KeyError:
                # What a result of this kind may lack, as the collapse load of an arch that does not stand.
                if any(name in getattr(one, "__annotations__", ()) for one in type(self).__mro__):
                    return None
                known = [one for one in dir(self) if not one.startswith("_")]
                meant = near(name, known)
                told = f"did you mean {' or '.join(meant)}?" if meant else f"it has {', '.join(known)}"
                raise AttributeError(f"this result has no `{name}`; {told}") from None

        def __setattr__(self, name: str, value: Any) -> None:
            if not name.startswith("_"):
                raise AttributeError(f"results are values: `{name}` cannot be set; to_dict() is a copy that can be changed")
            super().__setattr__(name, value)

    def __dir__(self) -> list[str]:
        return sorted({*super().__dir__(), *self._whole()})

    def to_dict(self) -> dict[str, Any]:
        """The object of the command's `result.json`, without the places of its files."""
        return dict(self._whole())

    def save(self, folder: str | os.PathLike[str]) -> Path:
        """Writes what the command writes into a folder, which is made where it is not there, and gives its path: `result.json`, drawings as SVG,
        tables, drawings for CAD and files for ParaView, the report of an assessment. Files of the same names are replaced. A result that was
        pickled has its drawings, tables and report alone."""
        folder = Path(folder)
        if folder.is_file():
            raise argument(f"folder = {str(folder)!r} cannot be used: it is a file", 'name a folder; `figure("mechanism").save("m.png")` writes one drawing')
        texts = {"result.json": (json.dumps(self._whole(), indent=2, ensure_ascii=False) + "\n").encode()}
        for name, content in {**self._answer.files(), **texts}.items():
            place = folder / name
            place.parent.mkdir(parents=True, exist_ok=True)
            place.write_bytes(content)
        return folder

    # ---- figures

    def figure(self, name: str) -> Figure:
        """A drawing by its name, such as "mechanism"; `figures` lists them."""
        drawn = self._answer.figure(name)
        if drawn is None:
            raise argument(f"this result has no figure {name!r}", f"it has {', '.join(self.figures) or 'none'}")
        return Figure(drawn)

    @property
    def figures(self) -> Mapping[str, Figure]:
        """All drawings, by their names."""
        return _Named({name: Figure(svg) for name, svg in self._answer.figures().items()}, "figure")

    def _repr_html_(self) -> str:
        rows = []
        for name in self._shown:
            value = getattr(self, name)
            if value is not None:
                text = f"{value:.6g}" if isinstance(value, float) else str(value)
                rows.append(f"<tr><th style='text-align:left'>{escape(name)}</th><td>{escape(text)}</td></tr>")
        figures = [drawn for drawn in map(self._answer.figure, self._main) if drawn is not None][:1]
        drawing = "".join(Figure(svg)._repr_html_() for svg in figures)
        count = len(self.warnings)
        warned = f"<p>{count} warning{'s' if count != 1 else ''}: <code>.warnings</code></p>" if count else ""
        return f"<table>{''.join(rows)}</table>{warned}{drawing}"

    def __repr__(self) -> str:
        shown = ((name, getattr(self, name)) for name in self._shown)
        told = ", ".join(
            f"{name}={value:.6g}" if isinstance(value, float) else f"{name}={value!r}"
            for name, value in shown
            if value is not None
        )
        return f"<extrados.{type(self).__name__}: {told}>"

    # ---- tables

    @property
    def tables(self) -> Mapping[str, Table]:
        """The command's tables as CSV, by their names; those without a row are left out."""
        return _Named({name: Table(text) for name, text in self._answer.tables().items() if text.count("\n") > 1}, "table")

    def _columns(self, table: str | None) -> dict[str, list[Any]]:
        tables = self.tables
        if table is None:
            table = next(iter(tables), None)
        if table is None or table not in tables:
            raise argument(f"this result has no table {table!r}", f"it has {', '.join(tables) or 'none'}")
        rows = list(csv.reader(io.StringIO(tables[table])))
        return {name: [_cell(row[k]) for row in rows[1:]] for k, name in enumerate(rows[0])}

    def to_pandas(self, table: str | None = None) -> Any:
        """A table as a data frame of pandas; the first of `tables` where none is named."""
        pandas = _library("pandas")
        return pandas.DataFrame(self._columns(table))

    def to_polars(self, table: str | None = None) -> Any:
        """A table as a data frame of polars."""
        polars = _library("polars")
        return polars.DataFrame(self._columns(table), strict=False)

    def to_xarray(self, table: str | None = None) -> Any:
        """A table as a dataset of xarray over its first column."""
        xarray = _library("xarray")
        columns = self._columns(table)
        first, *others = columns
        data = {name: (first, columns[name]) for name in others}
        return xarray.Dataset(data, coords={first: columns[first]}, attrs={"bridge": self._whole().get("bridge", "")})


def _library(name: str) -> Any:
    """A library that tables are given to; what to install where it is not there."""
    try:
        return importlib.import_module(name)
    except ImportError:
        raise argument(f"to_{name}() needs {name}, which is not installed", f"pip install {name}") from None


def _cell(text: str) -> Any:
    if text == "":
        return None
    for kind in (int, float):
        try:
            return kind(text)
        except ValueError:
            pass
    return {"true": True, "false": False}.get(text, text)


class Snapshot(_Part):
    """The blocks under one load. Arrays look into the result and cannot be written."""

    def __init__(self, answer: Answered, number: int, load_kn_per_m: float) -> None:
        self._answer, self._number = answer, number
        self.load_kn_per_m = load_kn_per_m
        """The load [kN/m]; a support movement in m where supports are moved."""

    def _array(self, name: str) -> Any:
        return self._answer.array(name, self._number)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Snapshot):
            return NotImplemented
        return self.load_kn_per_m == other.load_kn_per_m and _same_columns(self, other)

    def __hash__(self) -> int:
        return hash(self.load_kn_per_m)

    def __repr__(self) -> str:
        return f"<extrados.Snapshot: {self.load_kn_per_m:.6g} kN/m, {len(self.rotations_rad)} blocks, {len(self.contact_points_m)} contacts>"

    translations_m: Numbers = _column("translation", "Movement of each block's centroid, (blocks, 2).")
    rotations_rad: Numbers = _column("rotation", "Rotation of each block, anticlockwise, (blocks,).")
    velocities_m_per_s: Numbers = _column("velocity", "Velocity of each block's centroid, (blocks, 2).")
    block_stresses_pa: Numbers = _column("block_stress", "Average stress xx, yy, xy of each block, tension positive, (blocks, 3).")
    contact_blocks: Counts = _column("contact_blocks", "The two blocks of each contact, (contacts, 2).")
    contact_points_m: Numbers = _column("contact_point", "Where contacts are, (contacts, 2).")
    contact_normals: Numbers = _column("contact_normal", "Unit normal from the first block to the second, (contacts, 2).")
    contact_compressions_n_per_m: Numbers = _column("contact_compression", "Compression per metre of width, (contacts,).")
    contact_shears_n_per_m: Numbers = _column("contact_shear", "Shear per metre of width, (contacts,).")
    contact_stresses_pa: Numbers = _column("contact_stress", "Compressive stress, (contacts,).")
    contact_sliding: Flags = _column("contact_sliding", "Whether a contact slides, (contacts,).")
    particle_centres_m: Numbers = _column("disc_centre", "Centres of the particles, (particles, 2).")
    particle_angles_rad: Numbers = _column("disc_angle", "Angle turned since a particle was packed, (particles,).")
    particle_velocities_m_per_s: Numbers = _column("disc_velocity", "Velocities of the particles, (particles, 2).")
    particle_stresses_pa: Numbers = _column("disc_stress", "Average stress xx, yy, xy of each particle, tension positive, (particles, 3).")
    force_particles: Counts = _column("force_particle", "The particle on which each force acts, (forces,).")
    force_points_m: Numbers = _column("force_point", "Where forces act, (forces, 2).")
    force_compressions_n_per_m: Numbers = _column("force_compression", "Compression per metre of width, (forces,).")
    force_shears_n_per_m: Numbers = _column("force_shear", "Shear per metre of width, (forces,).")


class Collapse(_keys.Collapse, Result):
    """The load, the thickness or the support movement that makes a mechanism.

    >>> import extrados
    >>> found = extrados.Bridge.example("tiny").collapse(method="limit")
    >>> found.status, round(found.last_stable_load_kn_per_m, 1)
    ('collapsed', 160.2)
    >>> found.outline_m(3).shape, found.outline_m(3).flags.writeable
    ((4, 2), False)
    """

    _main = ("mechanism", "stress", "bridge")
    _shown = (
        "status", "method", "headline_kn_per_m", "last_stable_load_kn_per_m", "collapse_load_kn_per_m", "load_factor", "minimum_thickness_m",
        "minimum_thickness_over_mean_radius", "collapse_movement_m",
    )  # fmt: skip

    def outline_m(self, block: int) -> Numbers:
        """Outline of a block as built, anticlockwise, (corners, 2)."""
        if block < 0:
            raise argument(f"block = {block} cannot be used", f"there are {self._answer.count('blocks')} blocks, from 0")
        outline = self._answer.array("outline", block)
        if outline is None:
            raise argument(f"block = {block} cannot be used", f"there are {self._answer.count('blocks')} blocks, from 0")
        return outline

    @property
    def block_names(self) -> list[str]:
        """Names of the blocks, in the order of all arrays."""
        return self._answer.words("block_names")

    @property
    def block_roles(self) -> list[str]:
        """What the blocks are: "voussoir", "abutment", "pier", "backing", "wall", "block"."""
        return self._answer.words("block_roles")

    mechanism_translations_m: Numbers | None = _column(
        "mechanism_translation", "Movement of each block in the mechanism, scaled so that the largest is 1 m, (blocks, 2); None without a mechanism."
    )
    mechanism_rotations_rad: Numbers | None = _column("mechanism_rotation", "Rotation of each block in the mechanism, (blocks,).")
    hinge_points_m: Numbers = _column("hinge_point", "Where hinges are, (hinges, 2).")
    hinge_blocks: Counts = _column("hinge_blocks", "The two blocks of each hinge, (hinges, 2).")
    path_loads_n_per_m: Numbers = _column("path_load", "Load of every step of the load path, (steps,).")
    path_displacements_m: Numbers = _column("path_displacement", "Movement of the watched point at every step, (steps, 2).")

    @property
    def thrust_points_m(self) -> list[Numbers]:
        """Line of thrust of every span, (joints, 2) each."""
        return [self._answer.array("thrust_point", k) for k in range(self._answer.count("thrust_lines"))]

    @property
    def thrusts_n_per_m(self) -> list[Numbers]:
        """Size of the thrust there, (joints,) each."""
        return [self._answer.array("thrust", k) for k in range(self._answer.count("thrust_lines"))]

    particle_centres_m: Numbers = _column("particle_centre", "Centres of the particles as packed, (particles, 2).")
    particle_radii_m: Numbers = _column("particle_radius", "Radii of the particles, (particles,).")

    def plot(self, kind: Literal["load-displacement", "mechanism", "thrust-line"] | None = None, *, ax: Axes | None = None) -> Axes:
        """Draws on axes of matplotlib, new ones where none are given, and gives them: "load-displacement" (the load path), "mechanism" (no size of its
        own: the largest movement is drawn as a twentieth of the bridge) or "thrust-line". Where no kind is named, the first of them that there is."""
        from . import _plots

        return _plots.collapse(self, kind, ax)

    @property
    def snapshots(self) -> Sequence[Snapshot]:
        """The bridge at rest under each load, and on its way down."""
        loads = self._answer.words("snapshot_loads")
        return [Snapshot(self._answer, k, float(load) / 1e3) for k, load in enumerate(loads)]


class Sweep(_keys.Sweep, Result):
    """The loads of the file at every position."""

    _main = ("envelope",)
    _shown = ("status",)

    def plot(self, *, ax: Axes | None = None) -> Axes:
        """Draws the load factor over the position of the loads on axes of matplotlib, new ones where none are given, and gives them."""
        from . import _plots

        return _plots.sweep(self, ax)


class VehicleSweep(_keys.VehicleSweep, Result):
    """The vehicles of `[sweep]` at every position."""

    _main = ("adequacy", "envelope")
    _shown = ("status", "adequacy_factor")

    @property
    def adequacy_factor(self) -> float | None:
        """What the governing vehicle may be multiplied by; None where it is not known."""
        governing = self._whole().get("governing")
        return governing and governing.get("adequacy_factor")

    def plot(self, vehicles: Sequence[str] | None = None, *, ax: Axes | None = None) -> Axes:
        """Draws the adequacy factor of vehicles that are named by their codes, or of the governing one, over their position on axes of matplotlib, new
        ones where none are given, and gives them. Factors of more than five times the least lie outside."""
        from . import _plots

        return _plots.vehicles(self, vehicles, ax)


class Channel(_Part):
    """The record of a sensor."""

    def __init__(self, answer: Answered, number: int, name: str, unit: str, scale: float) -> None:
        self._answer, self._number = answer, number
        self.name = name
        self.unit = unit
        """Unit of tables and figures."""
        self.units_per_si = scale
        """How many of that unit an SI unit is."""

    @property
    def values_si(self) -> Numbers:
        """Values at every time in m, in strain or in Pa, self-weight taken off."""
        return self._answer.array("channel", self._number)

    @property
    def influence_si(self) -> Numbers | None:
        """Values for one axle at `influence_positions_m`; None where influence lines were not computed."""
        return self._answer.array("influence", self._number)

    @property
    def values(self) -> Numbers:
        """Values in `unit`: an array of its own."""
        return self.values_si * self.units_per_si

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Channel):
            return NotImplemented
        return (self.name, self.unit) == (other.name, other.unit) and _same_columns(self, other)

    def __hash__(self) -> int:
        return hash((self.name, self.unit))

    def __repr__(self) -> str:
        return f"<extrados.Channel: {self.name} [{self.unit}], {len(self.values_si)} values>"


class Moment(_Part):
    """The bridge at one moment of a passage."""

    def __init__(self, held: Answered | Told, name: str, number: int | None = None) -> None:
        self._held, self._number = held, number
        self.name = name

    def _array(self, name: str, within: int = 0) -> Any:
        if self._number is None:
            return self._held.array(name, within)
        return cast(Answered, self._held).array(name, self._number, within)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Moment):
            return NotImplemented
        return self.name == other.name and _same_columns(self, other) and same_columns(_pairs(self), _pairs(other))

    def __hash__(self) -> int:
        return hash(self.name)

    def __repr__(self) -> str:
        return f"<extrados.Moment: {self.name}, {len(self.displacements_m)} nodes, {len(self.stresses_pa)} elements>"

    displacements_m: Numbers = _column("displacement", "Displacement of every node, self-weight included, (nodes, 2).")
    stresses_pa: Numbers = _column("stress", "Stress xx, yy, xy, zz of every element, tension positive, (elements, 4).")
    yielding: Flags = _column("yielding", "Whether a point of an element yields, (elements,).")

    def joint(self, number: int) -> dict[str, Numbers]:
        """A joint or a contact of masonry with fill: points, tractions, openings and slidings of its pairs."""
        names = {"points_m": "point", "normal_pa": "normal", "shear_pa": "shear", "opening_m": "opening", "sliding_m": "sliding"}
        arrays = {key: self._array(f"pair_{name}", number) for key, name in names.items()}
        if arrays["points_m"] is None:
            raise argument(f"number = {number} cannot be used", "joints are numbered from 0")
        return arrays


def _pairs(moment: Moment) -> Iterator[tuple[Any, Any]]:
    """Arrays of all joints of a moment."""
    number = 0
    while moment._array("pair_point", number) is not None:
        yield from (((name, number), array) for name, array in moment.joint(number).items())
        number += 1


def _same_columns(one: Any, other: Any) -> bool:
    """Whether all columns of two parts are the same, by the names that they have in their class."""

    def own(part: Any) -> Iterator[tuple[str, Any]]:
        for name, member in vars(type(part)).items():
            if isinstance(member, property) and (array := getattr(part, name)) is not None:
                yield name, array

    return same_columns(own(one), own(other))


class Passage(_keys.Passage, Result):
    """Displacements, strains and stresses as a train crosses."""

    _main = ("records",)
    _shown = ("status", "train", "speed_km_per_h", "degrees_of_freedom", "load_positions")

    @property
    def records(self) -> dict[str, Channel]:
        """Records of the sensors, by their names."""
        words = self._answer.words
        rows = zip(words("channels"), words("channel_units"), words("channel_scales"))
        return {name: Channel(self._answer, k, name, unit, float(scale)) for k, (name, unit, scale) in enumerate(rows)}

    times_s: Numbers = _column("time", "Times of the records.")
    positions_m: Numbers = _column("position", "Position of the first axle at these times.")
    influence_positions_m: Numbers | None = _column("influence_position", "Places of the axle of influence lines.")
    nodes_m: Numbers = _column("node", "Nodes of the mesh, (nodes, 2).")
    element_nodes: Counts = _column("element", "Corners of every quadrilateral, anticlockwise, (elements, 4).")

    def plot(self, records: Sequence[str] | None = None, *, ax: Axes | None = None) -> Axes:
        """Draws records of one unit, those that are named or all that have the unit of the first, over the position of the first axle on axes of
        matplotlib, new ones where none are given, and gives them."""
        from . import _plots

        return _plots.passage(self, records, ax)

    @property
    def fields(self) -> Sequence[Moment]:
        """The bridge at the moments that are kept: under self-weight, and at peaks."""
        return [Moment(self._answer, name, k) for k, name in enumerate(self._answer.words("moments"))]

    def to_xarray(self, table: str | None = None) -> Any:
        """The records as a dataset of xarray over time, with units; another table where one is named."""
        if table is not None:
            return super().to_xarray(table)
        import xarray

        data = {
            name: ("time_s", one.values, {"unit": one.unit}) for name, one in self.records.items()
        }
        return xarray.Dataset(data, coords={"time_s": self.times_s, "position_m": ("time_s", self.positions_m)})


class Update(_keys.Update, Result):
    """Parameters from records of a passage."""

    evaluations_taken_up: int

    _main = ("histories",)
    _shown = ("status", "error_norm", "initial_error_norm", "evaluations")

    times_s: Numbers = _column("time", "Times of the histories.")

    @property
    def histories(self) -> dict[str, dict[str, Numbers]]:
        """By channel: what was measured, and what the start and the updated model give [m, strain or Pa]."""
        names = self._answer.words("channels")
        kinds = ("measured", "start", "updated")
        return {name: {kind: self._answer.array(kind, k) for kind in kinds} for k, name in enumerate(names)}

    @property
    def samples(self) -> Numbers | None:
        """Samples of the posterior, (samples, parameters), an array of its own; None where it was not sampled."""
        count = self._answer.count("samples")
        if count == 0:
            return None
        import numpy

        return numpy.stack([self._answer.array("sample", k) for k in range(count)])


class Study(_keys.Study, Result):
    """An analysis over ranges of the file's quantities."""

    tolerance: float
    seed: int

    _main = ("tornado", "response")
    _shown = ("status", "outcome", "runs", "runs_from_cache")

    def plot(self, quantity: str | None = None, *, ax: Axes | None = None) -> Axes:
        """Draws the outcome over the values of a quantity, of the first where none is named, on axes of matplotlib, new ones where none are given, and
        gives them. `to_pandas("runs")` has all runs."""
        from . import _plots

        return _plots.study(self, quantity, ax)


class Assessment(_keys.Assessment, Result):
    """The bridge against the limits of its file."""

    stages: list[dict[str, Any]]
    input_hash: str

    _shown = ("status", "verdict")

    @property
    def report_html(self) -> str:
        """The report as one self-contained page."""
        return self._answer.report() or ""


class Cases(Result):
    """The named cases of a file, side by side."""

    governing_case: str | None
    """The case with the least factor; None where a case has no answer."""
    load_factor: float | None
    """Its factor."""
    load_factor_at_most: float | None
    cases: list[dict[str, Any]]
    """Every case: `name`, `acts`, `load_factor`, `result`."""

    _main = ("cases",)
    _shown = ("status", "governing_case", "load_factor", "load_factor_at_most")


class Comparison(Result):
    """Two files: what they say differently, and both answers."""

    before_file: str
    after_file: str
    verdict: str
    """Which of the two carries more, in a sentence."""
    cautions: list[str]
    differences: list[dict[str, Any]]
    numbers: list[dict[str, Any]]
    assumptions_before_only: list[str]
    assumptions_after_only: list[str]
    before: dict[str, Any]
    after: dict[str, Any]

    _main = ("after/mechanism",)
    _shown = ("status", "verdict")

