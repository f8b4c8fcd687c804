"""What scripts and notebooks are shown: representations, suggestions, plots."""

import subprocess
import sys

import extrados
import numpy
import pytest


@pytest.fixture(scope="module")
def limit():
    return extrados.Bridge.example("bridgemill").collapse(method="limit")


@pytest.fixture(scope="module")
def dem():
    return extrados.Bridge.example("bridgemill").collapse(method="dem")


@pytest.fixture
def ax():
    return pytest.importorskip("matplotlib.figure").Figure().add_subplot()


# ---- representations


def test_representations_are_short_and_say_units(dem, small_passage):
    assert repr(dem.figure("mechanism")) == "<extrados.Figure: 160 mm x 80.2 mm; Bridgemill, case 1: discrete elements; Mechanism at collapse, 216.9 kN/m>"
    table = dem.tables["contacts"]
    rows = len(dem.to_pandas("contacts"))
    assert repr(table).startswith(f"<extrados.Table: {rows} rows of 11 columns: load_kn_per_m, first_block, second_block, x_m, ")
    assert repr(table).endswith("and 3 more>") and str(table).startswith("load_kn_per_m,") and isinstance(table, str)
    assert repr(dem.tables["hinges"]) == "<extrados.Table: 4 rows of 6 columns: x_m, y_m, edge, rotation, first_side, second_side>"
    assert repr(dem.snapshots[0]) == f"<extrados.Snapshot: 0 kN/m, 64 blocks, {len(dem.snapshots[0].contact_stresses_pa)} contacts>"
    passage = small_passage.respond()
    record = next(iter(passage.records.values()))
    assert repr(record) == f"<extrados.Channel: {record.name} [{record.unit}], {len(passage.times_s)} values>"
    assert f"{passage.nodes} nodes, {passage.elements} elements" in repr(passage.fields[0])
    for shown in (dem, dem.figures, dem.tables, dem.snapshots[3], passage.fields, passage.records):
        assert max(map(len, repr(shown).split("extrados."))) < 250 and "<svg" not in repr(shown)


def test_results_that_lack_a_field_can_be_shown():
    tiny = extrados.Bridge.example("tiny")
    ring = extrados.Bridge.example("semicircle").collapse()
    falls = tiny.with_(span_1_thickness="0.05 m", span_1_rise="2 m").collapse(method="limit")
    assert falls.status == "unstable-under-self-weight"
    assert (ring.collapse_load_kn_per_m, falls.collapse_load_kn_per_m) == (None, None)
    for found in (ring, falls):
        assert found.status in repr(found) and found.status in found._repr_html_() and "None" not in repr(found)
        assert hash(found) == hash(found)


# ---- suggestions


def test_names_that_are_nearly_right(limit):
    for name, meant in (
        ("headlin", "did you mean headline_from or headline_kn or headline_kn_per_m?"),
        ("last_stabel_load_kn", "did you mean last_stable_load_kn or "),
        ("hinge", "did you mean hinge_blocks or hinge_points_m or hinges?"),
        ("to_panda", "did you mean to_pandas"),
    ):
        with pytest.raises(AttributeError) as refusal:
            getattr(limit, name)
        assert f"no `{name}`; {meant}" in str(refusal.value)
    with pytest.raises(AttributeError, match="no `qqqq`; it has .*headline_kn_per_m"):
        _ = limit.qqqq
    assert not hasattr(limit, "_repr_jpeg_")


# ---- plots


def test_a_load_path(dem, ax):
    assert dem.plot(ax=ax) is ax
    path, stable = ax.get_lines()
    assert numpy.array_equal(path.get_ydata(), [one["load_kn_per_m"] for one in dem.path])
    assert numpy.allclose(path.get_xdata(), [-one["displacement_y_mm"] for one in dem.path], rtol=1e-14)
    assert stable.get_ydata()[0] == dem.last_stable_load_kn_per_m
    assert ax.get_xlabel().endswith("down positive [mm]") and ax.get_ylabel() == "load [kN/m]" and ax.get_title() == dem.bridge


def test_a_mechanism_stays_closed_at_its_hinges(limit, dem, ax):
    """The two blocks of a hinge bring its point to the same place: rigid bodies that turn about it."""
    from extrados import _plots

    for found in (limit, dem):
        moved = []
        for point, blocks in zip(found.hinge_points_m, found.hinge_blocks):
            moved.append(
                [
                    _plots._moved(point, found.mechanism_translations_m[k], found.mechanism_rotations_rad[k], _plots._centroid(found.outline_m(k)))
                    for k in blocks
                ]
            )
        apart = numpy.linalg.norm(numpy.diff(moved, axis=1), axis=-1)
        away = numpy.linalg.norm(numpy.mean(moved, axis=1) - found.hinge_points_m, axis=-1)
        assert len(moved) == 4 and apart.max() < 0.02 * away.max(), found.method
    limit.plot(ax=ax)
    built, drawn = ax.collections
    outlines = [limit.outline_m(k) for k in range(limit.blocks)]
    corners = numpy.concatenate(outlines)
    before, now = (
        numpy.concatenate([path.vertices[: len(outline)] for path, outline in zip(one.get_paths(), outlines, strict=True)]) for one in (built, drawn)
    )
    assert numpy.array_equal(before, corners)
    largest = numpy.abs(now - corners).max()
    assert largest == pytest.approx(0.05 * numpy.ptp(corners[:, 0]), rel=1e-9)
    assert (ax.get_xlabel(), ax.get_ylabel(), ax.get_aspect()) == ("x [m]", "y [m]", 1.0)
    (hinges,) = ax.get_lines()
    assert len(hinges.get_xdata()) == 4


def test_a_line_of_thrust(limit, ax):
    limit.plot("thrust-line", ax=ax)
    line = ax.get_lines()[0]
    assert numpy.array_equal(numpy.column_stack(line.get_data()), limit.thrust_points_m[0])
    assert [one.get_text() for one in ax.get_legend().get_texts()] == ["line of thrust", "hinge"]
    low, high = ax.get_ylim()
    assert low <= limit.outline_m(0)[:, 1].min() and high >= max(limit.outline_m(k)[:, 1].max() for k in range(limit.blocks))


def test_sweeps(ax):
    found = extrados.Bridge.example("tiny").sweep(step="0.5 m")
    found.plot(ax=ax)
    curve, governing = ax.get_lines()
    assert numpy.array_equal(curve.get_ydata(), [one["load_factor"] for one in found.positions])
    assert governing.get_ydata()[0] == curve.get_ydata().min() == found.governing["load_factor"]
    assert "[m]" in ax.get_xlabel() and ax.get_ylabel() == "load factor at collapse [-]"


def test_vehicles():
    pyplot = pytest.importorskip("matplotlib.figure")
    found = extrados.Bridge.example("vehicles").sweep(step="8 m")
    ax = found.plot([one["code"] for one in found.vehicles], ax=pyplot.Figure().add_subplot())
    least = {one["code"]: one["adequacy_factor"] for one in found.vehicles}
    curves = {one.get_label(): one.get_ydata() for one in ax.get_lines() if one.get_label() in least}
    assert curves.keys() == least.keys()
    assert all(numpy.nanmin(curves[code]) == pytest.approx(least[code], rel=1e-12) for code in least)
    # A vehicle that has hardly come onto the bridge would hide the others.
    assert max(map(numpy.nanmax, curves.values())) > 1e3 and ax.get_ylim() == (0.0, pytest.approx(5 * min(least.values())))
    ax = found.plot(ax=pyplot.Figure().add_subplot())
    curve, governing = ax.get_lines()
    assert curve.get_label() == found.governing["vehicle"]
    assert governing.get_label() == f"governing: {found.adequacy_factor:.4g} at {found.governing['position_m']:.4g} m, by dem"
    ax = found.plot(["lm71"], ax=pyplot.Figure().add_subplot())
    assert [one.get_label() for one in ax.get_lines()] == ["lm71"]
    with pytest.raises(extrados.ArgumentError, match="vehicles = 'lm72'"):
        found.plot(["lm72"])


def test_records(small_passage, ax):
    found = small_passage.respond()
    name, record = next(iter(found.records.items()))
    found.plot([name], ax=ax)
    (curve,) = ax.get_lines()
    assert numpy.array_equal(curve.get_ydata(), record.values) and numpy.array_equal(curve.get_xdata(), found.positions_m)
    assert (record.unit, ax.get_ylabel()) == ("mm", "displacement [mm]")
    other = next((one.name for one in found.records.values() if one.unit != record.unit), None)
    if other is not None:
        with pytest.raises(extrados.ArgumentError, match="same axes"):
            found.plot([name, other])
    with pytest.raises(extrados.ArgumentError, match="records = 'no such'"):
        found.plot(["no such"])


def test_what_cannot_be_drawn(limit, ax):
    with pytest.raises(extrados.ArgumentError, match="no load path"):
        limit.plot("load-displacement", ax=ax)
    with pytest.raises(extrados.ArgumentError, match="kind = 'stress'.*\n.*load-displacement, mechanism, thrust-line"):
        limit.plot("stress", ax=ax)
    with pytest.raises(extrados.ArgumentError, match="ax = int"):
        limit.plot(ax=3)


def test_axes_are_made_where_none_are_given_and_matplotlib_is_left_alone_until_then():
    pytest.importorskip("matplotlib")
    script = """
import sys, extrados
found = extrados.Bridge.example("tiny").collapse(method="limit")
repr(found), found._repr_html_(), found.tables
assert "matplotlib" not in sys.modules
import matplotlib
matplotlib.use("agg")
print(type(found.plot()).__name__, len(found.plot("thrust-line").get_lines()))
"""
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    assert done.stdout.split() == ["Axes", "2"]
