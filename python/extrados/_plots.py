"""Curves and outlines of results on axes of matplotlib, which is imported here and nowhere else."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from .errors import argument

if TYPE_CHECKING:
    from collections.abc import Sequence

    from .results import Collapse, Passage, Study, Sweep, VehicleSweep

_LARGEST = 0.05
"""Largest movement of a mechanism that is drawn, in lengths of the bridge."""
_SEEN = 5.0
"""Largest factor of a sweep within the axes, in times the least: a vehicle that has hardly come onto the bridge may be multiplied without end."""
_STONE, _GROUND, _EDGE, _BUILT, _MARK = "#f2e8d5", "#dcdcdc", "#1a1a1a", "#b0b0b0", "#0b5394"


def axes(given: Any) -> Any:
    """The axes that were given, or those of a new figure."""
    if given is not None:
        if not hasattr(given, "plot") or not hasattr(given, "set_xlabel"):
            raise argument(f"ax = {type(given).__name__} cannot be used", "give axes of matplotlib, as plt.subplots() makes them")
        return given
    try:
        from matplotlib import pyplot
    except ImportError:
        raise argument("plots need matplotlib, which is not installed", "pip install matplotlib, or use figure(name)") from None
    return pyplot.subplots(layout="constrained")[1]


def _titled(ax: Any, found: Any, across: str, up: str) -> Any:
    ax.set(xlabel=across, ylabel=up)
    if not ax.get_title():
        ax.set_title(found.to_dict().get("bridge", ""))
    return ax


# ---- collapse


def load_displacement(found: Collapse, ax: Any) -> Any:
    """Load over the vertical movement of the watched point, down positive."""
    movements, loads = found.path_displacements_m, found.path_loads_n_per_m
    if len(loads) == 0:
        raise argument('kind = "load-displacement" cannot be used: this result has no load path', 'compute it by method="dem" or method="path"')
    ax.plot(-1e3 * movements[:, 1], loads / 1e3, color=_MARK, marker=".", label="load path")
    stable = found.last_stable_load_kn_per_m
    if stable is not None:
        ax.axhline(stable, color=_BUILT, linestyle="--", label=f"last stable: {stable:.4g} kN/m")
    ax.legend()
    return _titled(ax, found, "vertical displacement, down positive [mm]", "load [kN/m]")


def thrust_line(found: Collapse, ax: Any) -> Any:
    """The line of thrust within the blocks as built."""
    lines = [line for line in found.thrust_points_m if len(line)]
    if not lines:
        raise argument('kind = "thrust-line" cannot be used: this result has no line of thrust', "see its status")
    _blocks(ax, [found.outline_m(k) for k in range(found.blocks)], facecolor=_colours(found), edgecolor=_BUILT)
    for number, line in enumerate(lines):
        ax.plot(line[:, 0], line[:, 1], color=_MARK, label="line of thrust" if number == 0 else None)
    _hinges(ax, found.hinge_points_m)
    ax.legend()
    return _elevation(ax, found)


def mechanism(found: Collapse, ax: Any) -> Any:
    """The blocks as they begin to move, over the blocks as built."""
    import numpy

    translations, rotations = found.mechanism_translations_m, found.mechanism_rotations_rad
    if translations is None or rotations is None:
        raise argument('kind = "mechanism" cannot be used: this result has no mechanism', "see its status")
    built = [found.outline_m(k) for k in range(found.blocks)]
    corners = numpy.concatenate(built)
    moved = [_moved(outline, translations[k], rotations[k]) for k, outline in enumerate(built)]
    largest = max(numpy.abs(now - before).max() for now, before in zip(moved, built))
    # A mechanism has a shape and no size.
    scale = _LARGEST * numpy.ptp(corners[:, 0]) / largest if largest > 0.0 else 0.0
    _blocks(ax, built, facecolor="none", edgecolor=_BUILT, linestyle=":")
    drawn = [before + scale * (now - before) for now, before in zip(moved, built)]
    _blocks(ax, drawn, facecolor=_colours(found), edgecolor=_EDGE)
    points = [
        point + scale * (_moved(point, translations[one], rotations[one], _centroid(built[one])) - point)
        for point, (one, _) in zip(found.hinge_points_m, found.hinge_blocks)
    ]
    _hinges(ax, numpy.reshape(points, (-1, 2)))
    return _elevation(ax, found)


def _moved(points: Any, translation: Any, rotation: Any, centre: Any = None) -> Any:
    """Points of a block after a small movement about its centroid: the rotation is that of its velocities, so that hinges stay closed."""
    import numpy

    arm = points - (_centroid(points) if centre is None else centre)
    return points + translation + rotation * numpy.stack([-arm[..., 1], arm[..., 0]], axis=-1)


def _centroid(outline: Any) -> Any:
    """Centroid of the area within an outline."""
    import numpy

    first = outline[0]
    x, y = (outline - first).T
    cross = x * numpy.roll(y, -1) - numpy.roll(x, -1) * y
    return first + [((one + numpy.roll(one, -1)) * cross).sum() / (3.0 * cross.sum()) for one in (x, y)]


def _colours(found: Collapse) -> list[str]:
    """Stones of the rings in one colour, what they stand on in another."""
    return [_GROUND if role == "abutment" else _STONE for role in found.block_roles]


def _blocks(ax: Any, outlines: Sequence[Any], **style: Any) -> None:
    from matplotlib.collections import PolyCollection

    ax.add_collection(PolyCollection(outlines, linewidths=0.6, **style), autolim=True)


def _hinges(ax: Any, points: Any) -> None:
    if len(points):
        told = "hinge" in ax.get_legend_handles_labels()[1]
        ax.plot(
            points[:, 0], points[:, 1], linestyle="none", marker="o", markerfacecolor="white", markeredgecolor=_EDGE, label=None if told else "hinge", zorder=5
        )


def _elevation(ax: Any, found: Any) -> Any:
    ax.set_aspect("equal")
    ax.autoscale_view()
    return _titled(ax, found, "x [m]", "y [m]")


COLLAPSE = {"load-displacement": load_displacement, "mechanism": mechanism, "thrust-line": thrust_line}


def collapse(found: Collapse, kind: str | None, ax: Any) -> Any:
    """One of the plots of a collapse: the load path where there is one, the mechanism otherwise, unless one is named."""
    if kind is None:
        moves = "thrust-line" if found.mechanism_translations_m is None else "mechanism"
        kind = "load-displacement" if len(found.path_loads_n_per_m) else moves
    if kind not in COLLAPSE:
        raise argument(f"kind = {kind!r} cannot be used", f"give one of {', '.join(COLLAPSE)}")
    return COLLAPSE[kind](found, axes(ax))


# ---- sweeps


def sweep(found: Sweep, ax: Any) -> Any:
    """Load factor over the position of the loads; positions without an answer leave a gap."""
    ax = axes(ax)
    rows = found.positions
    factors = [_number(one["load_factor"]) for one in rows]
    ax.plot([one["position_m"] for one in rows], factors, color=_MARK, marker=".", label="load factor")
    _governing(ax, found.governing, "load_factor")
    _room(ax, factors)
    return _titled(ax, found, "position of the reference point along the bridge [m]", "load factor at collapse [-]")


def vehicles(found: VehicleSweep, codes: Sequence[str] | None, ax: Any) -> Any:
    """Adequacy factor of the governing vehicle or of those that are named over their position, the least of all axles and weights at each."""
    governing = found.governing
    table = found._columns("envelope")
    known = list(dict.fromkeys(table["vehicle"]))
    wrong = [one for one in codes or () if one not in known]
    if wrong:
        raise argument(f"vehicles = {', '.join(map(repr, wrong))} cannot be used", f"there are {', '.join(known)}")
    if codes is None:
        codes = known[:1] if governing is None else [governing["vehicle"]]
    ax = axes(ax)
    factors: list[float] = []
    for code in codes:
        least: dict[float, float] = {}
        for vehicle, position, factor in zip(table["vehicle"], table["position_m"], table["adequacy_factor"]):
            if vehicle == code:
                before = least.get(position)
                least[position] = _number(factor) if before is None else min(before, _number(factor))
        places = sorted(least)
        ax.plot(places, [least[place] for place in places], marker=".", label=code)
        factors += least.values()
    if governing and governing["vehicle"] in codes:
        _governing(ax, governing, "adequacy_factor")
    _room(ax, factors)
    ax.legend(fontsize="small")
    return _titled(ax, found, "position of the first axle along the bridge [m]", "adequacy factor [-]")


def _governing(ax: Any, governing: dict[str, Any] | None, name: str) -> None:
    factor = governing and governing.get(name)
    if governing and factor is not None:
        place = governing["position_m"]
        label = f"governing: {factor:.4g} at {place:.4g} m"
        if "method" in governing:
            label += f", by {governing['method']}"
        ax.plot([place], [factor], linestyle="none", marker="o", markerfacecolor="white", markeredgecolor=_EDGE, label=label)
        ax.legend()


def _room(ax: Any, factors: Sequence[float]) -> None:
    """Axes from zero to some times the least factor, where there are larger ones."""
    least = min((one for one in factors if one == one), default=0.0)
    if least > 0.0 and any(one > _SEEN * least for one in factors):
        ax.set_ylim(0.0, _SEEN * least)


def _number(value: float | None) -> float:
    return float("nan") if value is None else value


# ---- passages

_MEASURED = {"mm": "displacement", "m": "displacement", "µε": "strain", "microstrain": "strain", "MPa": "stress", "kPa": "stress"}
"""What records of a unit measure."""


def passage(found: Passage, names: Sequence[str] | None, ax: Any) -> Any:
    """Records over the position of the first axle: those that are named, or all that have the unit of the first."""
    records = found.records
    wrong = [one for one in names or () if one not in records]
    if wrong:
        raise argument(f"records = {', '.join(map(repr, wrong))} cannot be used", f"there are {', '.join(records)}")
    unit = records[names[0]].unit if names else next(iter(records.values())).unit
    shown = [one for one in records.values() if (one.unit == unit if names is None else one.name in names)]
    if any(one.unit != unit for one in shown):
        units = ", ".join(dict.fromkeys(one.unit for one in shown))
        raise argument(f"records in {units} cannot be drawn on the same axes", "name records of one unit")
    ax = axes(ax)
    for one in shown:
        ax.plot(found.positions_m, one.values, label=one.name)
    ax.legend(fontsize="small")
    return _titled(ax, found, "position of the first axle along the bridge [m]", f"{_MEASURED.get(unit, 'value of the record')} [{unit}]")


# ---- studies


def study(found: Study, quantity: str | None, ax: Any) -> Any:
    """The outcome over the values of a quantity, those of the other quantities as the file has them; runs without an answer leave a gap."""
    ranges = {one["quantity"]: one for one in found.quantities}
    if quantity is None:
        quantity = next(iter(ranges))
    if quantity not in ranges:
        raise argument(f"quantity = {quantity!r} cannot be used", f"there are {', '.join(ranges)}")
    unit = ranges[quantity]["unit"]
    own = found.baseline
    rows = [row for row in found.rows if row["varied"] in (quantity, None) and quantity in row["values"]]
    known = sorted((row["values"][quantity], _number(row["outcomes"].get(found.outcome))) for row in rows)
    if len(known) < 2:
        raise argument(f"quantity = {quantity!r} cannot be drawn: it has one value", "vary it over several values")
    ax = axes(ax)
    if len(ranges) > 1 and found.design == "grid":
        raise argument("a grid of several quantities is no curve", 'draw figure("heat-map"), or pick runs of to_pandas()')
    ax.plot([value for value, _ in known], [outcome for _, outcome in known], color=_MARK, marker=".")
    if own is not None and own["outcomes"].get(found.outcome) is not None:
        place = own["values"].get(quantity)
        ax.plot([place], [own["outcomes"][found.outcome]], linestyle="none", marker="o", markerfacecolor="white", markeredgecolor=_EDGE, label="the file")
        ax.legend()
    across = f"{quantity} [{unit}]" if unit else str(quantity)
    return _titled(ax, found, across, _LEADING.get(found.outcome, found.outcome))


_LEADING = {"headline_kn_per_m": "load carried [kN/m]", "last_stable_load_kn_per_m": "load carried [kN/m]", "adequacy_factor": "adequacy factor [-]", "load_factor": "load factor [-]"}
"""What studies are about, in words."""
