"""Faults on a cluster: workers that are killed, a scheduler that is killed, a disk that is full, files that poison. The run ends, its report names
what failed, nothing is computed twice or lost, and the numbers are those of an undisturbed run."""

import os
import signal
import socket
import subprocess
import sys
import threading
import time

import extrados
import pytest

distributed = pytest.importorskip("dask.distributed")
pytest.importorskip("pyarrow")

import cloudpickle  # noqa: E402
from extrados import cluster  # noqa: E402

# Workers know nothing of this file.
cloudpickle.register_pickle_by_value(sys.modules[__name__])

COUNT = 80
VALUES = [{"joint.friction_angle": f"{25 + k / 8} deg"} for k in range(COUNT)]


@pytest.fixture(scope="module")
def bridge():
    return extrados.Bridge.example("tiny")


@pytest.fixture(scope="module")
def undisturbed(bridge):
    """Loads without a cluster."""
    return [bridge.with_(one).collapse(method="limit").last_stable_load_kn_per_m for one in VALUES]


@pytest.fixture(autouse=True)
def slower(monkeypatch):
    """Tasks of a twentieth of a second at least, so that something is under way when something is killed; workers inherit it."""
    monkeypatch.setenv("EXTRADOS_TEST_PAUSE", "0.05")


def paused(self, *options, _collapse=extrados.Bridge.collapse, **words):
    time.sleep(float(os.environ.get("EXTRADOS_TEST_PAUSE", "0")))
    return _collapse(self, *options, **words)


class Slow(distributed.WorkerPlugin):
    """Makes the tasks of a worker slower."""

    def setup(self, worker):
        extrados.Bridge.collapse = paused


def results(store):
    """Results of a store and when they were written."""
    return {path.stem: path.stat().st_mtime_ns for path in (store / "results").glob("*.json")}


def wait_for(store, count, ended=None):
    end = time.monotonic() + 120
    while len(results(store)) < count and not (ended and ended.is_set()):
        assert time.monotonic() < end, f"{len(results(store))} results and not {count}"
        time.sleep(0.02)


def assert_all(report, store, undisturbed):
    """Every task once, and the numbers of an undisturbed run."""
    assert report.failed == []
    rows = report.to_pandas()
    assert list(rows["last_stable_load_kn_per_m"]) == undisturbed
    assert sorted(rows["key"]) == sorted(results(store))


class Machines:
    """A scheduler and two workers, each a process of its own."""

    def __init__(self):
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            self.port = free.getsockname()[1]
        self.address = f"tcp://127.0.0.1:{self.port}"
        self.running = []
        self.start()

    def start(self):
        quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
        module = [sys.executable, "-m"]
        place = ["--host", "127.0.0.1", "--no-dashboard"]
        self.scheduler = subprocess.Popen([*module, "distributed.cli.dask_scheduler", "--port", str(self.port), *place], **quiet)
        workers = [*module, "distributed.cli.dask_worker", self.address, "--nthreads", "1", "--nworkers", "2", *place]
        self.running += [self.scheduler, subprocess.Popen(workers, start_new_session=True, **quiet)]

    def stop(self):
        for one in self.running:
            if one.poll() is None:
                one.kill() if one is self.scheduler else os.killpg(one.pid, signal.SIGKILL)
            one.wait()


@pytest.fixture
def machines():
    made = Machines()
    yield made
    made.stop()


def client_of(machines):
    client = distributed.Client(machines.address, timeout=60)
    client.register_plugin(Slow())
    client.wait_for_workers(2, timeout=120)
    return client


def test_a_scheduler_that_is_killed_and_started_again(machines, bridge, undisturbed, tmp_path):
    before = {}

    def kill():
        wait_for(tmp_path, COUNT // 4)
        machines.scheduler.kill()
        machines.scheduler.wait()
        time.sleep(0.5)
        before.update(results(tmp_path))
        machines.start()

    client = client_of(machines)
    thread = threading.Thread(target=kill)
    thread.start()
    try:
        report = cluster.vary(bridge, VALUES, store=tmp_path, client=client, method="limit")
    finally:
        thread.join()
        client.close()
    assert COUNT // 4 <= len(before) < COUNT
    assert_all(report, tmp_path, undisturbed)
    # What was finished before was not written again.
    after = results(tmp_path)
    assert all(after[key] == written for key, written in before.items())


def test_a_scheduler_that_does_not_come_back_is_a_reason_and_the_next_call_goes_on(machines, bridge, undisturbed, tmp_path):
    client = client_of(machines)

    def kill():
        wait_for(tmp_path, COUNT // 4)
        machines.stop()

    thread = threading.Thread(target=kill)
    thread.start()
    report = cluster.vary(bridge, VALUES, store=tmp_path, client=client, patience=2.0, method="limit")
    thread.join()
    client.close()
    assert report.failed and len(report.failed) < COUNT
    assert all("were lost" in reason for _, reason in report.failed)
    before = results(tmp_path)
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=":0", host="127.0.0.1") as local:
        with distributed.Client(local) as own:
            again = cluster.vary(bridge, VALUES, store=tmp_path, client=own, method="limit")
    assert again.taken_up == len(before) and again.computed == COUNT - len(before)
    assert_all(again, tmp_path, undisturbed)


def test_a_worker_killed_again_and_again(bridge, undisturbed, tmp_path, monkeypatch):
    monkeypatch.setenv("EXTRADOS_TEST_PAUSE", "0.3")
    killed, ended = [], threading.Event()
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=":0", host="127.0.0.1") as local:
        with distributed.Client(local) as client:
            client.register_plugin(Slow())

            def kill():
                wait_for(tmp_path, 5, ended)
                # Every 5 s, the longest-lived first; the first at once.
                while not ended.is_set():
                    workers = [one.pid for one in local.workers.values() if one.pid]
                    if workers:
                        killed.append(workers[0])
                        os.kill(workers[0], signal.SIGKILL)
                    ended.wait(5.0)

            thread = threading.Thread(target=kill)
            thread.start()
            try:
                report = cluster.vary(bridge, VALUES, store=tmp_path, client=client, method="limit")
            finally:
                ended.set()
                thread.join()
    assert len(killed) >= 2
    assert_all(report, tmp_path, undisturbed)


def deadly(self, *options, _collapse=extrados.Bridge.collapse, **words):
    if "31.0 deg" in self.text:
        os.kill(os.getpid(), signal.SIGKILL)
    return _collapse(self, *options, **words)


class Deadly(distributed.WorkerPlugin):
    """One of the tasks kills its worker."""

    def setup(self, worker):
        extrados.Bridge.collapse = deadly


def test_a_task_that_kills_every_worker_is_a_row_and_harms_nothing_else(bridge, undisturbed, tmp_path):
    import dask

    with dask.config.set({"distributed.scheduler.allowed-failures": 1}):
        local = distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=":0", host="127.0.0.1")
        with local, distributed.Client(local) as client:
            client.register_plugin(Deadly())
            # Blocks of several tasks from the start.
            cluster.vary(bridge, VALUES[:8], store=tmp_path, client=client, method="limit")
            report = cluster.vary(bridge, VALUES, store=tmp_path, client=client, method="limit")
    [(name, reason)] = report.failed
    assert "31.0 deg" in name and reason.startswith("KilledWorker"), reason
    loads = list(report.to_pandas()["last_stable_load_kn_per_m"])
    at = VALUES.index({"joint.friction_angle": "31.0 deg"})
    assert loads[:at] + loads[at + 1 :] == undisturbed[:at] + undisturbed[at + 1 :]


def test_a_disk_that_is_full(bridge, undisturbed, tmp_path):
    """A file that cannot grow, as on a full disk: the write itself fails, half-way."""

    def limit(size):
        import resource

        resource.setrlimit(resource.RLIMIT_FSIZE, (size, resource.RLIM_INFINITY))

    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=":0", host="127.0.0.1") as local:
        with distributed.Client(local) as client:
            cluster.vary(bridge, VALUES[:10], store=tmp_path, client=client, method="limit")
            before = results(tmp_path)
            client.run(limit, 1000)
            report = cluster.vary(bridge, VALUES, store=tmp_path, client=client, method="limit")
            assert report.taken_up == 10 and report.computed == 0 and len(report.failed) == COUNT - 10
            assert all("File too large" in reason for _, reason in report.failed)
            # No half of a result, and nothing that was there is gone.
            assert results(tmp_path) == before and list((tmp_path / "results").glob("*.part")) == []
            client.run(limit, -1)
            again = cluster.vary(bridge, VALUES, store=tmp_path, client=client, method="limit")
    assert again.taken_up == 10 and again.computed == COUNT - 10
    assert_all(again, tmp_path, undisturbed)


def test_files_that_poison_are_rows_with_their_reasons(bridge, tmp_path):
    folder = tmp_path / "bridges"
    folder.mkdir()
    (folder / "a.toml").write_text(bridge.text)
    (folder / "empty.toml").write_text("")
    (folder / "bytes.toml").write_bytes(bytes(range(256)))
    (folder / "deep.toml").write_text("a = " + "[" * 20_000)
    (folder / "folder.toml").mkdir()
    (folder / "huge.toml").write_text(bridge.text.replace('"4.0 m"', '"4e300 m"'))
    (folder / "many.toml").write_text(bridge.text.replace("voussoirs = 21", "voussoirs = 2000000000"))
    paths = sorted(folder.glob("*.toml"))
    with distributed.LocalCluster(n_workers=1, threads_per_worker=1, dashboard_address=":0", host="127.0.0.1") as local:
        with distributed.Client(local) as client:
            report = cluster.fleet(paths, "collapse", store=tmp_path / "store", client=client, method="limit")
    assert report.computed == 1
    assert [os.path.basename(name) for name, _ in report.failed] == [path.name for path in paths[1:]]
    assert all(reason for _, reason in report.failed)
