"""Results, bridges and what they hold are values: they go through pickle, copies and other processes, and compare by what was found."""

import copy
import pickle
import re
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context

import extrados
import numpy
import pytest
from extrados import _held, results

NAMED_CASES = '\n[[case]]\nname = "as built"\n\n[[case]]\nname = "heavy"\nmasonry_weight = 1.2\n'


def tiny(**edits):
    return extrados.Bridge.example("tiny").with_(**edits) if edits else extrados.Bridge.example("tiny")


def collapse_of(thickness: str):
    """What a process of a pool computes, and sends back."""
    return tiny(span_1_thickness=thickness).collapse(method="limit")


def load_of(found):
    return found.last_stable_load_kn_per_m


MADE = {
    "collapse": lambda: tiny().collapse(method="limit"),
    "collapse by discrete elements": lambda: extrados.Bridge.example("bridgemill").collapse(method="dem"),
    "sweep": lambda: tiny().sweep(step="0.5 m"),
    "vehicles": lambda: extrados.Bridge.example("vehicles").sweep(step="8 m"),
    "vary": lambda: tiny().vary("joint.friction_angle=30deg..40deg:3", method="limit"),
    "assess": lambda: extrados.Bridge.example("packhorse").assess(skip=["sensitivity", "support-movement"]),
    "records alone": lambda: extrados.Bridge.example("update").update(records_only=True),
    "cases": lambda: extrados.Bridge.parse(tiny().text + NAMED_CASES).cases(method="limit"),
    "compare": lambda: tiny().compare(tiny(span_1_thickness="0.45 m"), method="limit"),
}


@pytest.fixture
def block_model(root, tmp_path):
    """A block model file with its drawing."""
    for name in ("arch.dxf", "bridge.toml"):
        (tmp_path / name).write_bytes((root / "examples/drawing" / name).read_bytes())
    return tmp_path / "bridge.toml"


@pytest.fixture(scope="module")
def found(small_passage):
    return {name: make() for name, make in MADE.items()} | {"passage": small_passage.respond()}


@pytest.mark.parametrize("name", [*MADE, "passage"])
def test_results_come_back_whole(found, name):
    one = found[name]
    again = pickle.loads(pickle.dumps(one))
    assert type(again) is type(one) and again == one and hash(again) == hash(one) and repr(again) == repr(one)
    assert again.to_dict() == one.to_dict()
    assert dict(again.figures) == dict(one.figures) and dict(again.tables) == dict(one.tables)
    assert again._repr_html_() == one._repr_html_()
    # Once more, from what was pickled itself.
    assert pickle.loads(pickle.dumps(again)) == one
    assert copy.copy(one) == one and copy.deepcopy(one) == one and copy.deepcopy(again) == one


def test_results_of_different_kinds_and_bridges_differ(found):
    assert len(set(found.values())) == len(found)
    assert found["collapse"] != collapse_of("0.41 m") and found["collapse"] == tiny().collapse(method="limit")
    assert found["collapse"] != "collapsed" and found["collapse"] != found["sweep"]
    kept = found["collapse"].to_dict()
    kept["hinges"][0]["x_m"] += 1e-12
    changed = pickle.loads(pickle.dumps(found["collapse"]))
    changed._answer._told["object"] = kept
    assert changed != found["collapse"]


def test_a_study_taken_up_is_the_same_study(found):
    one, again = found["vary"], MADE["vary"]()
    assert [row["seconds"] for row in one.rows] != [row["seconds"] for row in again.rows] and one == again


def test_columns_come_back_and_cannot_be_written(found):
    one = found["collapse by discrete elements"]
    again = pickle.loads(pickle.dumps(one))
    assert len(again.snapshots) == len(one.snapshots) > 3
    assert again.snapshots == one.snapshots and again.snapshots[2] != one.snapshots[3]
    assert numpy.array_equal(again.outline_m(4), one.outline_m(4)) and not numpy.array_equal(again.outline_m(4), one.outline_m(5))
    assert numpy.array_equal(again.thrust_points_m[0], one.thrust_points_m[0]) and again.block_names == one.block_names
    assert not again.outline_m(0).flags.writeable and not again.snapshots[0].rotations_rad.flags.writeable
    with pytest.raises(extrados.ArgumentError, match="block = 999"):
        again.outline_m(999)
    with pytest.raises(extrados.ArgumentError, match="no figure 'no'"):
        again.figure("no")


def test_a_passage_comes_back(found):
    one = found["passage"]
    again = pickle.loads(pickle.dumps(one))
    assert again.records == one.records and numpy.array_equal(again.times_s, one.times_s)
    assert again.fields == one.fields and again.fields[0] != one.fields[1]
    assert again.fields[0].joint(1)["points_m"].shape == one.fields[0].joint(1)["points_m"].shape
    assert again.to_xarray().identical(one.to_xarray())
    first = pickle.loads(pickle.dumps(next(iter(one.records.values()))))
    assert first in one.records.values() and numpy.array_equal(first.values, one.records[first.name].values)


def test_histories_of_an_update_come_back():
    text = extrados.Bridge.example("update")
    one = text.update(records_only=True)
    again = pickle.loads(pickle.dumps(one))
    assert one.histories.keys() == again.histories.keys()
    for name, kinds in one.histories.items():
        assert all(numpy.array_equal(kinds[kind], again.histories[name][kind]) for kind in kinds), name


def test_every_column_of_the_module_is_kept(root):
    source = (root / "crates/python/src/arrays.rs").read_text()
    arrays, counts = source.split("pub(crate) fn count(")
    names = set(re.findall(r'^ +"(\w+)" =>', arrays, re.MULTILINE))
    kept = {*_held._ONCE, *_held._PAIRS, *(name for names in _held._SEVERAL.values() for name in names)}
    assert names == kept and len(names) > 50
    counted = set(re.findall(r'"(\w+)"\) =>', counts))
    assert counted == {*_held._SEVERAL, *_held._WORDS, "rows", "figures"}


def test_bridges_are_values(tmp_path):
    one, edited = tiny(), tiny(span_1_thickness="0.45 m")
    assert one == tiny() and hash(one) == hash(tiny()) and one != edited and one != one.text
    assert edited == tiny(span_1_thickness="0.45 m") and pickle.loads(pickle.dumps(edited)) == edited
    assert copy.copy(one) == one and copy.deepcopy(one) == one and len({one, tiny(), edited}) == 2
    check = extrados.Bridge.parse("[bridge]\nname = 3\n").check()
    assert pickle.loads(pickle.dumps(check)) == check != one.check() and str(pickle.loads(pickle.dumps(check))) == str(check)
    assert pickle.loads(pickle.dumps(one.quantities)) == one.quantities


def test_what_a_bridge_names_counts(tmp_path):
    """The same text beside other records is another bridge."""
    example = extrados.Bridge.example("update")
    files = example._project.files()
    records = next(name for name in files if name.endswith(".csv"))
    assert extrados.Bridge.parse(example.text, name=example.name, files=files) == example
    files[records] += b"\n"
    assert extrados.Bridge.parse(example.text, name=example.name, files=files) != example
    # And so it is where they lie on the disk and change between two readings.
    path = tmp_path / example.name
    for name, content in example._project.files().items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_bytes(content)
    first = extrados.Bridge.read(path)
    assert first == extrados.Bridge.read(path) and pickle.loads(pickle.dumps(first)) == first
    assert first.key() == extrados.Bridge.read(path).key()
    lines = (tmp_path / records).read_text().splitlines()
    (tmp_path / records).write_text("\n".join(lines[:-1]) + "\n")
    assert extrados.Bridge.read(path) != first


def test_block_models_are_values(block_model):
    one = extrados.Blocks.read(block_model)
    again = pickle.loads(pickle.dumps(one))
    assert again == one == copy.deepcopy(one) and hash(again) == hash(one)
    assert again.collapse(method="limit") == one.collapse(method="limit")
    block_model.write_text("# another\n" + block_model.read_text())
    assert extrados.Blocks.read(block_model) != one == again


def test_runs_in_hand_say_that_they_stay(small_passage):
    run = extrados.Bridge.example("bridgemill").collapse_run(method="dem")
    run.advance(200)
    frame = run.frame()
    assert pickle.loads(pickle.dumps(frame)) == frame == run.frame() and copy.deepcopy(frame) == frame
    run.advance(200)
    assert run.frame() != frame
    for call in (pickle.dumps, copy.copy, copy.deepcopy):
        with pytest.raises(TypeError, match="CollapseRun goes on where it was made"):
            call(run)
    assert pickle.loads(pickle.dumps(run.finish())) == extrados.runs.Ended(None, None, 400)
    passage = small_passage.passage_run()
    passage.advance(1)
    moment = passage.moment()
    again = pickle.loads(pickle.dumps(moment))
    assert again == moment and again.joint(0).keys() == moment.joint(0).keys() and not again.stresses_pa.flags.writeable
    passage.advance(1)
    assert passage.moment() != moment


def test_figures_and_errors():
    drawn = tiny().collapse(method="limit").figure("mechanism")
    again = pickle.loads(pickle.dumps(drawn))
    assert type(again) is results.Figure and again == drawn == copy.deepcopy(drawn)
    stopped = extrados.Interrupted(tiny().collapse(method="limit"), "state")
    again = pickle.loads(pickle.dumps(stopped))
    assert again.result == stopped.result and again.state == "state" and str(again) == str(stopped)


def test_other_processes():
    thicknesses = ["0.4 m", "0.45 m", "0.5 m"]
    here = [collapse_of(one) for one in thicknesses]
    with ProcessPoolExecutor(2, mp_context=get_context("spawn")) as pool:
        there = list(pool.map(collapse_of, thicknesses))
        assert there == here and list(pool.map(load_of, here)) == [load_of(one) for one in here]
    assert there[1].figure("mechanism") == here[1].figure("mechanism")


def test_joblib():
    joblib = pytest.importorskip("joblib")
    thicknesses = ["0.4 m", "0.45 m"]
    there = joblib.Parallel(n_jobs=2)(joblib.delayed(collapse_of)(one) for one in thicknesses)
    assert there == [collapse_of(one) for one in thicknesses]


def test_a_cache_of_joblib(tmp_path):
    joblib = pytest.importorskip("joblib")
    memory = joblib.Memory(tmp_path, verbose=0)
    seen = []

    def load(bridge):
        seen.append(bridge.name)
        return bridge.collapse(method="limit")

    cached = memory.cache(load)
    assert cached(tiny()) == cached(tiny()) and len(seen) == 1
    assert cached(tiny(span_1_thickness="0.45 m")) != cached(tiny()) and len(seen) == 2


def test_dask():
    distributed = pytest.importorskip("dask.distributed")
    import dask

    settings = {"threads_per_worker": 1, "dashboard_address": "127.0.0.1:0", "host": "127.0.0.1"}
    thicknesses = ["0.4 m", "0.45 m"]
    with distributed.LocalCluster(n_workers=2, **settings) as cluster, distributed.Client(cluster) as client:
        there = client.gather(client.map(tiny().__class__.collapse, [tiny(span_1_thickness=one) for one in thicknesses], method="limit"))
        assert there == [collapse_of(one) for one in thicknesses]
        bridges = [dask.delayed(tiny())]
        (delayed,) = dask.compute(bridges[0].collapse(method="limit"))
        assert delayed == tiny().collapse(method="limit")


def test_results_are_values_and_say_what_they_found():
    found = extrados.Bridge.example("semicircle").collapse()
    assert "minimum_thickness_m=1.06" in repr(found)
    with pytest.raises(AttributeError, match="results are values: `status` cannot be set"):
        found.status = "x"
    with pytest.raises(extrados.ArgumentError, match="from 0"):
        found.outline_m(-1)


def test_a_study_draws_itself_and_names_the_runs_that_warn():
    pyplot = pytest.importorskip("matplotlib.pyplot")
    study = extrados.Bridge.example("tiny").vary({"joint.friction_angle [deg]": [28.0, 30.0, 33.0]}, method="limit")
    rows = study.to_pandas("runs")
    told = {one["code"]: one["message"] for one in study.warnings if one["message"].startswith("in ")}
    for code, message in told.items():
        runs = [k for k, row in enumerate(study.rows) if code in row["warnings"]]
        assert 0 < len(runs) < len(rows) and f"({', '.join(map(str, runs))})" in message
    ax = study.plot()
    (line,) = ax.get_lines()[:1]
    assert list(line.get_xdata()) == sorted(row["values"]["joint.friction_angle"] for row in study.rows) and ax.get_ylabel() == "load carried [kN/m]"
    pyplot.close(ax.figure)
    with pytest.raises(extrados.ArgumentError, match="there are joint.friction_angle"):
        study.plot("span")
