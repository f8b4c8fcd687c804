"""Fleets and samples on local processes: a poisoned file is a row, what is finished is not repeated, a killed worker loses one task at most."""

import json
import os
import signal
import threading

import extrados
import pytest

distributed = pytest.importorskip("dask.distributed")
pytest.importorskip("pyarrow")

from extrados import cluster  # noqa: E402


@pytest.fixture(scope="module")
def client():
    with (
        distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None, host="127.0.0.1") as local,
        distributed.Client(local) as own,
    ):
        yield own


@pytest.fixture
def bridges(tmp_path):
    folder = tmp_path / "bridges"
    folder.mkdir()
    tiny = extrados.Bridge.example("tiny")
    for k in range(8):
        (folder / f"bridge-{k}.toml").write_text(tiny.with_({"joint.friction_angle": f"{30 + k} deg"}).text)
    (folder / "poisoned.toml").write_text(tiny.text.replace('rise = "1.0 m"', 'rise = "2.85 GPa"'))
    (folder / "same-as-3.toml").write_text("# a comment changes nothing\n" + (folder / "bridge-3.toml").read_text())
    return sorted(folder.glob("*.toml"))


def test_a_fleet(client, bridges, tmp_path):
    report = cluster.fleet([*bridges, tmp_path / "missing.toml"], "collapse", store=tmp_path / "store", client=client, method="limit")
    rows = report.to_pandas().set_index("name")
    assert report.tasks == len(rows) == 11
    assert [name.rsplit("/", 1)[-1] for name, _ in report.failed] == ["poisoned.toml", "missing.toml"]
    assert "line 8: expected a length, found a pressure (B104)" in dict(report.failed)[str(bridges[-2])]
    for path in bridges[:8]:
        alone = extrados.Bridge.read(path).collapse(method="limit")
        row = rows.loc[str(path)]
        assert row["last_stable_load_kn_per_m"] == alone.last_stable_load_kn_per_m
        kept = report.result(row["key"])
        assert json.dumps(kept["hinges"]) == json.dumps(alone.hinges)
    # Two files that mean the same share a result.
    assert rows.loc[str(bridges[3]), "key"] == rows.loc[str(bridges[-1]), "key"]
    again = cluster.fleet(bridges, "collapse", store=tmp_path / "store", client=client, method="limit")
    assert again.computed == 0 and again.taken_up == 9 and len(again.failed) == 1


def test_samples(client, tmp_path):
    tiny = extrados.Bridge.example("tiny")
    values = [{"joint.friction_angle": f"{angle} deg", "masonry.density": "x1.05"} for angle in (30, 35, 40)]
    values.append({"joint.friction_angle": "95 deg"})
    report = cluster.vary(tiny, values, store=tmp_path, client=client, method="limit")
    loads = report.to_pandas()["last_stable_load_kn_per_m"]
    assert list(loads[:3]) == [tiny.with_(one).collapse(method="limit").last_stable_load_kn_per_m for one in values[:3]]
    assert len(report.failed) == 1 and "95 deg" in report.failed[0][0]


def test_killed_workers_repeat_nothing_that_was_finished(bridges, tmp_path):
    text = extrados.Bridge.example("tiny").text
    values = [{"joint.friction_angle": f"{25 + k / 4} deg"} for k in range(60)]
    bridge = extrados.Bridge.parse(text)
    with (
        distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None, host="127.0.0.1") as local,
        distributed.Client(local) as client,
    ):
        killed, ended = [], threading.Event()

        def kill():
            for finished in (10, 30):
                while len(list((tmp_path / "results").glob("*.json"))) < finished:
                    if ended.wait(0.02):
                        return
                workers = [one.pid for one in local.workers.values() if one.pid]
                killed.append(workers[0])
                os.kill(workers[0], signal.SIGKILL)

        thread = threading.Thread(target=kill)
        thread.start()
        report = cluster.vary(bridge, values, store=tmp_path, client=client, method="limit")
        ended.set()
        thread.join()
    results = {path.stem: path.stat().st_mtime_ns for path in (tmp_path / "results").glob("*.json")}
    assert killed and report.failed == [] and len(results) == 60
    rows = report.to_pandas()
    # Every result was written once: what a killed worker had finished was taken up.
    assert sorted(rows["key"]) == sorted(results)
    for k in (0, 30, 59):
        alone = bridge.with_(values[k]).collapse(method="limit").last_stable_load_kn_per_m
        assert rows["last_stable_load_kn_per_m"][k] == alone


def test_a_disk_that_is_full_is_a_reason(tmp_path, monkeypatch):
    def full(*_args, **_words):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(cluster, "_keep", full)
    row = cluster._one("a", extrados.Bridge.example("tiny"), "collapse", {"method": "limit"}, str(tmp_path))
    assert row["status"] == "failed" and "No space left" in row["reason"]


def test_costs_change_the_order_and_nothing_else(client, tmp_path):
    tiny = extrados.Bridge.example("tiny")
    values = [{"joint.friction_angle": f"{30 + k / 10} deg"} for k in range(30)]
    plain = cluster.vary(tiny, values, store=tmp_path / "plain", client=client, method="limit")
    costs = [float(k % 7) for k in range(30)]
    ordered = cluster.vary(tiny, values, store=tmp_path / "ordered", client=client, costs=costs, method="limit")
    rows = [one.to_pandas().drop(columns=["seconds", "wall_seconds"], errors="ignore") for one in (plain, ordered)]
    assert rows[0].equals(rows[1]) and ordered.computed == 30
    for wrong in ([1.0], [float("nan")] * 30, [-1.0] * 30):
        with pytest.raises(extrados.ArgumentError, match="one number for each of 30 tasks"):
            cluster.vary(tiny, values, store=tmp_path, client=client, costs=wrong, method="limit")


def test_blocks_are_of_equal_time_and_shrink_towards_the_end():
    class Client:
        cluster = None

    costs = [4.0] * 100 + [1.0] * 1000
    crew = cluster._Crew(Client(), [("", None)] * 1100, costs, ("collapse", {}, ""), 1.0)
    crew.workers = 4
    assert len(crew._block()) == 1, "nothing is measured"
    crew.count, crew.seconds, crew.cost = 8, 0.8, 8.0
    blocks = []
    while crew.waiting:
        blocks.append(crew._block())
    taken = [sum(costs[one] for one in block) for block in blocks]
    assert sorted(one for block in blocks for one in block) == list(range(1, 1100)), "each once, the longest first"
    assert taken[0] == 8.0 and len(blocks[0]) == 2, "0.8 s in tasks of 0.4 s"
    assert max(taken) <= 10.0 and taken[-1] <= 1.0
    assert all(later <= earlier + 2.0 for earlier, later in zip(taken, taken[1:]))
