"""Records as frames, arrays and files of other programs: the same answer as from the file of the example."""

import io
import re

import extrados
import numpy
import pytest
from extrados import records

pandas = pytest.importorskip("pandas")


@pytest.fixture(scope="module")
def bridge():
    return extrados.Bridge.example("update")


@pytest.fixture(scope="module")
def frame(root):
    return pandas.read_csv(root / "examples/railway-arch/table-6.csv", comment="#")


@pytest.fixture(scope="module")
def judged(bridge):
    return bridge.update(records_only=True)


def peaks(found) -> list:
    return [(one["name"], one["measured_peak"]) for one in found.channels]


def test_frames_of_pandas_and_polars(bridge, frame, judged):
    polars = pytest.importorskip("polars")
    one = bridge.update(frame, records_only=True)
    assert peaks(one) == peaks(judged) and len(peaks(one)) > 3
    assert numpy.array_equal(one.histories["crown displacement"]["measured"], judged.histories["crown displacement"]["measured"])
    two = bridge.update(polars.from_pandas(frame), records_only=True)
    assert peaks(two) == peaks(judged)
    doubled = frame.assign(**{"crown displacement [mm]": 2 * frame["crown displacement [mm]"]})
    three = bridge.update(doubled, records_only=True)
    assert peaks(three)[0][1] == pytest.approx(2 * peaks(judged)[0][1], rel=1e-9)


def test_numbers_are_kept_to_their_last_bit(frame):
    again = pandas.read_csv(io.StringIO(records.as_csv(frame)))
    for name in frame:
        assert numpy.array_equal(again[name].to_numpy(float), frame[name].to_numpy(float)), name


@pytest.mark.parametrize(
    ("table", "named"),
    [
        ({"time [s]": [0.0, 1.0], "a [mm]": ["x", "y"]}, "'a \\[mm\\]' has the dtype <U1"),
        ({"time [s]": [0.0, 1.0], "a [mm]": [1 + 2j, 0]}, "dtype complex128"),
        ({"time [s]": [0.0, 1.0], "a [mm]": numpy.zeros((2, 2))}, "'a \\[mm\\]' has the shape \\(2, 2\\)"),
        ({"time [s]": [0.0, 1.0], "a [mm]": [1.0]}, "'a \\[mm\\]' has 1 values, the first column 2"),
        ({"time [s]": [0.0, 1.0], "a [mm]": [1.0, float("nan")]}, "'a \\[mm\\]' has nan in row 1"),
        ({"time [s]": [0.0, 1.0]}, "it needs"),
        ({"time [s]": [0.0, 1.0], "a, b [mm]": [1.0, 2.0]}, "comma"),
        (7, "type int"),
    ],
)
def test_what_is_no_table_is_refused_by_the_name_of_its_column(bridge, table, named):
    with pytest.raises(extrados.ArgumentError, match=named):
        bridge.update(table)


def test_a_channel_without_a_unit_is_named_by_the_reader(bridge, frame):
    found = None
    try:
        found = bridge.update(frame.rename(columns={"crown displacement [mm]": "crown displacement"}), records_only=True)
    except extrados.Error as error:
        assert "crown displacement" in str(error)
    assert found is None or any(one["code"] == "R011" for one in found.warnings)


NAMES = {"t": "time [s]", "w": "crown displacement [mm]"}


def as_arrays(frame):
    return {key: frame[heading].to_numpy(float) for key, heading in NAMES.items()}


def same(table, frame):
    assert list(table) == list(NAMES.values())
    for heading in NAMES.values():
        assert numpy.array_equal(numpy.asarray(table[heading]), frame[heading].to_numpy(float))
    assert records.as_csv(table).startswith("time [s],crown displacement [mm]\n")


def test_matlab(tmp_path, frame):
    io = pytest.importorskip("scipy.io")
    io.savemat(tmp_path / "run.mat", as_arrays(frame))
    same(records.read_mat(tmp_path / "run.mat", NAMES), frame)
    with pytest.raises(extrados.ArgumentError, match="no x"):
        records.read_mat(tmp_path / "run.mat", {"x": "x [mm]"})


def test_hdf5(tmp_path, frame):
    h5py = pytest.importorskip("h5py")
    with h5py.File(tmp_path / "run.h5", "w") as file:
        for name, values in as_arrays(frame).items():
            file[f"run/{name}"] = values
    same(records.read_hdf5(tmp_path / "run.h5", {f"run/{name}": heading for name, heading in NAMES.items()}), frame)


def test_tdms(tmp_path, frame):
    nptdms = pytest.importorskip("nptdms")
    channels = [nptdms.ChannelObject("run", name, values) for name, values in as_arrays(frame).items()]
    with nptdms.TdmsWriter(str(tmp_path / "run.tdms")) as writer:
        writer.write_segment(channels)
    same(records.read_tdms(tmp_path / "run.tdms", NAMES, time=None), frame)
    with pytest.raises(extrados.ArgumentError, match="no clock"):
        records.read_tdms(tmp_path / "run.tdms", {"w": NAMES["w"]})


def test_records_in_memory_need_no_place_in_the_file(bridge, frame):
    without = re.sub(r"(?ms)^\[records\].*?(?=^\[)", "", bridge.text)
    assert "[records]" not in without
    alone = extrados.Bridge.parse(without).update(frame, records_only=True)
    # Without the table its other keys have their defaults.
    named = extrados.Bridge.parse(bridge.text.replace("zero = false", "zero = true"))
    assert len(peaks(alone)) > 3 and peaks(alone) == peaks(named.update(frame, records_only=True))
    with pytest.raises(extrados.ArgumentError, match="cannot be read: No such file"):
        extrados.Bridge.parse(without).update("nowhere.csv")
