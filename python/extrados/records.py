"""Records of a passage for :meth:`extrados.Bridge.update`: data frames, arrays, and files of other programs.

Records are one table, or several by the names of their runs. A table is a data frame of pandas or polars, or a dictionary of arrays, whose
columns are headed as in a file of records: ``time [s]``, ``crown displacement [mm]``. The library's own reader judges it and names every
doubt. What is no number, has another shape or is not finite is refused by the name of its column.

>>> import numpy, extrados.records
>>> table = {"time [s]": numpy.array([0.0, 0.1]), "crown displacement [mm]": numpy.array([0.0, -0.2])}
>>> print(extrados.records.as_csv(table), end="")
time [s],crown displacement [mm]
0.0,0.0
0.1,-0.2
"""

from __future__ import annotations

import os
import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ._extrados import Project
from .errors import argument

if TYPE_CHECKING:
    from .bridge import Bridge

__all__ = ["as_csv", "read_hdf5", "read_mat", "read_tdms"]

Table = Any
"""A data frame of pandas or polars, or a dictionary of arrays."""
Records = Any
"""A table, or tables by the names of their runs, or None."""


def as_csv(table: Table, *, speed: str | None = None) -> str:
    """A table as a file of records, every number to its last bit. `speed` is that of the train, such as "45 km/h"."""
    import numpy

    columns = _columns(table)
    if len(columns) < 2:
        raise argument(f"a table with the columns {list(columns)} cannot be used", 'it needs "time [s]" and a channel such as "crown displacement [mm]"')
    length, arrays = None, []
    for name, values in columns.items():
        array = numpy.asarray(values)
        if array.dtype.kind not in "fiu":
            raise argument(f"column {name!r} has the dtype {array.dtype}", "give numbers (float or integer)")
        if array.ndim != 1:
            raise argument(f"column {name!r} has the shape {array.shape}", "give one value for each time")
        length = len(array) if length is None else length
        if len(array) != length:
            raise argument(f"column {name!r} has {len(array)} values, the first column {length}", "give as many values as times")
        array = array.astype(numpy.float64)
        wrong = numpy.flatnonzero(~numpy.isfinite(array))
        if len(wrong):
            raise argument(
                f"column {name!r} has {array[wrong[0]]} in row {wrong[0]}, and {len(wrong)} such values in all",
                "drop these rows, or the column",
            )
        if any(character in name for character in ",\n\r\""):
            raise argument(f"column {name!r} has a comma, a quote or a line break in its name", "rename it")
        arrays.append(array.tolist())
    head = [f"# speed: {speed}"] if speed else []
    rows = (",".join(map(repr, row)) for row in zip(*arrays))
    return "\n".join([*head, ",".join(columns), *rows]) + "\n"


def _columns(table: Table) -> dict[str, Any]:
    if isinstance(table, Mapping):
        return {str(name): values for name, values in table.items()}
    names = getattr(table, "columns", None)
    if names is not None and hasattr(table, "__getitem__"):
        return {str(name): table[name].to_numpy() for name in names}
    fields = getattr(getattr(table, "dtype", None), "names", None)
    if fields:
        return {name: table[name] for name in fields}
    raise argument(
        f"records of the type {type(table).__name__} cannot be used",
        "give a data frame of pandas or polars, a dictionary of arrays, or a structured array",
    )


def as_files(bridge: Bridge, records: Records) -> Project:
    """The project of a bridge with records in memory in the place of those that its file names."""
    place, text = bridge._project.records_place(), bridge.text
    if place is None:
        if re.search(r"^\s*(\[+\s*records\b|records\s*[.=])", text, re.MULTILINE):
            # The project itself tells what is wrong with it.
            return bridge._project
        # Records in memory need no place in the file.
        place = "records.csv"
        text = f'{text.rstrip()}\n\n[records]\nplace = "{place}"\n'
    path = os.path.join(os.path.dirname(bridge.name), place)
    runs = _runs(records)
    files = dict(bridge._project.files())
    for known in [name for name in files if name == path or os.path.dirname(name) == path]:
        del files[known]
    if len(runs) == 1 and not os.path.isdir(path):
        files[path] = next(iter(runs.values())).encode()
    else:
        files |= {os.path.join(path, f"{name}.csv"): text.encode() for name, text in runs.items()}
    files[bridge.name] = text.encode()
    return Project.read(bridge.name, files)


def _runs(records: Records) -> dict[str, str]:
    if isinstance(records, (str, Path)):
        path = Path(records)
        try:
            return {path.stem: path.read_text(encoding="utf-8")}
        except (OSError, UnicodeDecodeError) as error:
            why = getattr(error, "strerror", None) or "it is no text"
            raise argument(f"records = {str(records)!r} cannot be read: {why}", "give a table, or the path of a table of records (.csv)") from None
    several = isinstance(records, Mapping) and all(
        isinstance(one, Mapping) or hasattr(one, "columns") for one in records.values()
    )
    if several and records:
        return {_plain(name): as_csv(table) for name, table in records.items()}
    return {"records": as_csv(records)}


def _plain(name: Any) -> str:
    text = str(name)
    if not text or any(character in text for character in "/\\\0") or text.startswith("."):
        raise argument(f"a run with the name {text!r} cannot be used", "give names without slashes")
    return text


# ---- files of other programs


def read_mat(path: str | os.PathLike[str], names: Mapping[str, str]) -> dict[str, Any]:
    """Variables of a MATLAB file (`.mat`, versions 4 to 7.2) as a table, by scipy: `names` gives the heading of each variable,
    `{"t": "time [s]", "w": "crown displacement [mm]"}`. Files of version 7.3 are HDF5: :func:`read_hdf5`."""
    from scipy.io import loadmat

    found = loadmat(os.fspath(path), squeeze_me=True)
    known = [name for name in found if not name.startswith("__")]
    return _picked(found, names, known, path)


def read_hdf5(path: str | os.PathLike[str], names: Mapping[str, str]) -> dict[str, Any]:
    """Data sets of an HDF5 file as a table, by h5py: `names` gives the heading of each, `{"run/t": "time [s]"}`."""
    import h5py
    import numpy

    with h5py.File(os.fspath(path), "r") as file:
        known: list[str] = []
        found: dict[str, Any] = {}

        def look(name: str, one: Any) -> None:
            if isinstance(one, h5py.Dataset):
                known.append(name)
                if name in names:
                    found[name] = numpy.squeeze(numpy.asarray(one[()]))

        file.visititems(look)
    return _picked(found, names, known, path)


def read_tdms(
    path: str | os.PathLike[str], names: Mapping[str, str], *, group: str | None = None, time: str | None = "time [s]"
) -> dict[str, Any]:
    """Channels of a TDMS file as a table, by npTDMS: `names` gives the heading of each channel of `group`, of the first where none is named.
    `time` is the heading of the clock that the first channel's properties tell; None where a channel of its own holds the times."""
    from nptdms import TdmsFile

    file = TdmsFile.read(os.fspath(path))
    groups = {one.name: one for one in file.groups()}
    chosen = groups.get(group) if group is not None else next(iter(groups.values()), None)
    if chosen is None:
        raise argument(f"group = {group!r} is not in {os.fspath(path)}", f"it has {', '.join(groups) or 'no group'}")
    found = {one.name: one[:] for one in chosen.channels()}
    table = _picked(found, names, list(found), path)
    if time is None:
        return table
    first = next(one for one in chosen.channels() if one.name in names)
    try:
        clock = first.time_track()
    except KeyError:
        raise argument(
            f"channel {first.name!r} of {os.fspath(path)} has no clock",
            "give the heading of the channel that holds the times, and time=None",
        ) from None
    return {time: clock, **table}


def _picked(
    found: Mapping[str, Any], names: Mapping[str, str], known: Sequence[str], path: str | os.PathLike[str]
) -> dict[str, Any]:
    missing = [name for name in names if name not in found]
    if missing:
        raise argument(f"{os.fspath(path)} has no {', '.join(missing)}", f"it has {', '.join(known) or 'nothing'}")
    return {heading: found[name] for name, heading in names.items()}
