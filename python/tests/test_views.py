"""Arrays look into results: no copy is made, nothing can be written, and they outlive the names of what they look into."""

import gc

import extrados
import numpy
import pytest


def address(array: numpy.ndarray) -> int:
    return array.__array_interface__["data"][0]


@pytest.fixture(scope="module")
def collapse():
    return extrados.Bridge.example("bridgemill").collapse(method="dem")


def test_arrays_show_the_memory_of_the_result(collapse):
    snapshot = collapse.snapshots[3]
    for name in ("translations_m", "contact_compressions_n_per_m", "contact_points_m", "contact_blocks", "contact_sliding"):
        one, two = getattr(snapshot, name), getattr(snapshot, name)
        assert len(one) > 0 and one is not two, name
        # Two copies that live at the same time would not share an address.
        assert address(one) == address(two), name
        assert one.base is collapse._answer and not one.flags.owndata and not one.flags.writeable, name
    # Fields of one row of the table of contacts lie within the row, and rows follow one another.
    points, forces = snapshot.contact_points_m, snapshot.contact_compressions_n_per_m
    row = forces.strides[0]
    assert row > points.itemsize * 2 and points.strides == (row, 8)
    assert abs(address(points) - address(forces)) < row


def test_numbers_are_those_of_the_tables(collapse):
    table = collapse.to_pandas("path")
    assert numpy.array_equal(collapse.path_loads_n_per_m / 1e3, [one["load_kn_per_m"] for one in collapse.path])
    assert len(table) == len(collapse.path_loads_n_per_m)
    assert len(collapse.block_names) == len(collapse.block_roles) == len(collapse.snapshots[0].rotations_rad)
    hinges = numpy.array([[one["x_m"], one["y_m"]] for one in collapse.hinges])
    assert numpy.array_equal(collapse.hinge_points_m, hinges)
    assert collapse.snapshots[0].contact_compressions_n_per_m.min() >= 0


def test_an_array_outlives_its_result():
    found = extrados.Bridge.example("tiny").collapse(method="limit")
    outline = found.outline_m(2)
    line = found.thrust_points_m[0]
    kept = (outline.copy(), line.copy())
    del found
    gc.collect()
    # Fill the memory that would have been given back.
    others = [extrados.Bridge.example("tiny").collapse(method="limit") for _ in range(20)]
    assert numpy.array_equal(outline, kept[0]) and numpy.array_equal(line, kept[1])
    assert len(others) == 20


def test_nothing_can_be_written(collapse):
    with pytest.raises(ValueError, match="read-only"):
        collapse.outline_m(0)[0, 0] = 1.0
    with pytest.raises(ValueError):
        collapse.outline_m(0).flags.writeable = True


def test_what_is_not_there(collapse):
    limit = extrados.Bridge.example("tiny").collapse(method="limit")
    assert limit.particle_centres_m.shape == (0, 2)
    with pytest.raises(extrados.ArgumentError, match="block = 999"):
        limit.outline_m(999)
    with pytest.raises(AttributeError, match="no_such_load"):
        _ = limit.no_such_load


def test_a_passage(small_passage):
    found = small_passage.respond()
    records = found.records
    assert list(records) == [one["name"] for one in found.channels]
    for one in found.channels:
        record = records[one["name"]]
        assert address(record.values_si) == address(record.values_si)
        assert record.values_si.base is found._answer
        assert max(record.values.max(), -record.values.min()) == pytest.approx(abs(one["peak"]), rel=1e-12)
    data = found.to_xarray()
    assert data.sizes["time_s"] == found.load_positions == len(found.times_s)
    field = found.fields[0]
    assert field.displacements_m.shape == (found.nodes, 2) and field.stresses_pa.shape == (found.elements, 4)
    assert found.element_nodes.max() < found.nodes
    assert set(field.joint(0)) == {"points_m", "normal_pa", "shear_pa", "opening_m", "sliding_m"}


def test_frames():
    pytest.importorskip("polars")
    found = extrados.Bridge.example("tiny").sweep(step="0.5 m")
    frame = found.to_polars()
    assert frame.height == len(found.positions)
    assert found.to_pandas()["load_factor"].min() == pytest.approx(found.governing["load_factor"])
    with pytest.raises(extrados.ArgumentError, match="no table"):
        found.to_pandas("hinges")
