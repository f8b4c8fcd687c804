"""What a fleet costs: 1000 bridges with sweeps, alone and on 1 and 2 workers. Writes measured.json beside this file, for simulate.py.

    python docs/scale/measure.py [COUNT]

Times are of the processor, and not of a clock, where they can be: other work on the machine does not count then.
"""

import json
import os
import platform
import random
import sys
import tempfile
import time
from pathlib import Path

os.environ["EXTRADOS_THREADS"] = "1"

import dask
import extrados
from dask.distributed import Client, LocalCluster
from extrados import cluster

COUNT = int(sys.argv[1]) if len(sys.argv) > 1 else 1000
STEP = "0.3 m"
# Examples that are varied, with their shares: from 4 m to four spans of 6 m.
KINDS = {"tiny": 0.35, "bridgemill": 0.3, "packhorse": 0.25, "passage": 0.1}
VARIED = ("span[1].thickness", "masonry.density", "joint.friction_angle")


def draw(folder):
    """Bridge files: examples with thickness, density and friction up to a tenth less or more."""
    dice = random.Random(1)
    for number in range(COUNT):
        bridge = extrados.Bridge.example(dice.choices(list(KINDS), list(KINDS.values()))[0])
        edits = {path: f"x{dice.uniform(0.9, 1.1):.4f}" for path in VARIED}
        (folder / f"bridge-{number:04}.toml").write_text(bridge.with_(edits).text, encoding="utf-8")
    return sorted(folder.glob("*.toml"))


def alone(paths):
    """Seconds of the processor for each bridge: reading it, and its sweep."""
    costs = []
    for path in paths:
        begun = time.process_time()
        extrados.Bridge.read(path).sweep(step=STEP, method="limit").to_dict()
        costs.append(time.process_time() - begun)
    return costs


def processor():
    import time

    return time.process_time()


def on_workers(paths, count, store):
    """The fleet on this many workers: seconds of the processor in workers and in this process, and of the clock."""
    with LocalCluster(n_workers=count, threads_per_worker=1, dashboard_address=":0", host="127.0.0.1") as local, Client(local) as client:
        client.wait_for_workers(count)
        # A first task imports what every worker imports once.
        cluster.vary(extrados.Bridge.example("tiny"), [{"masonry.density": f"{2000 + k} kg/m^3"} for k in range(4 * count)], client=client, store=store / "warm")
        here, there, clock = time.process_time(), sum(client.run(processor).values()), time.perf_counter()
        report = cluster.fleet(paths, "sweep", store=store, client=client, step=STEP, method="limit")
        found = {
            "workers": count,
            "worker_cpu_seconds": sum(client.run(processor).values()) - there,
            "scheduler_and_client_cpu_seconds": time.process_time() - here,
            "wall_seconds": time.perf_counter() - clock,
            "computed": report.computed,
            "failed": len(report.failed),
        }
    found["busy_share"] = float(report.to_pandas()["seconds"].sum()) / (count * found["wall_seconds"])
    return found, report


def blocks_of_nothing(count=3000):
    """Seconds of the processor for a block that does nothing: in the scheduler with the client, and in a worker."""
    with LocalCluster(n_workers=1, threads_per_worker=1, dashboard_address=":0", host="127.0.0.1") as local, Client(local) as client:
        client.submit(len, (), pure=False).result()
        here, there = time.process_time(), sum(client.run(processor).values())
        flying = []
        for _ in range(count):
            flying.append(client.submit(len, (1,), pure=False))
            if len(flying) > 4:
                flying.pop(0).result()
        client.gather(flying)
        return (time.process_time() - here) / count, (sum(client.run(processor).values()) - there) / count


def keeping(store, found, count=300):
    """Seconds of the clock to keep one result: written, flushed to the disk, moved into place."""
    begun = time.perf_counter()
    for number in range(count):
        cluster._keep(store / f"probe-{number}.json", found)
    return (time.perf_counter() - begun) / count


if __name__ == "__main__":
    # As in the cluster that extrados starts by itself: without the profile of every worker.
    dask.config.set({"distributed.worker.profile.enabled": False})
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        (folder / "bridges").mkdir()
        paths = draw(folder / "bridges")
        costs = alone(paths)
        runs, rows = [], []
        for count in (1, 2):
            run, report = on_workers(paths, count, folder / f"store-{count}")
            runs.append(run)
            rows.append(report.to_pandas().drop(columns=["seconds", "wall_seconds"], errors="ignore"))
        assert rows[0].equals(rows[1]), "the same bits on one worker and on two"
        scheduler, worker = blocks_of_nothing()
        result = max((folder / "store-2/results").glob("*.json"), key=lambda path: path.stat().st_size)
        sizes = [path.stat().st_size for path in (folder / "store-2/results").glob("*.json")]
        measured = {
            "machine": platform.machine(),
            "cores": os.cpu_count(),
            "load_average": os.getloadavg()[0],
            "bridges": COUNT,
            "cpu_seconds_alone": sum(costs),
            "runs": runs,
            "cpu_efficiency": {str(run["workers"]): sum(costs) / run["worker_cpu_seconds"] for run in runs},
            "scheduler_cpu_seconds_per_block": scheduler,
            "worker_cpu_seconds_per_block": worker,
            "worker_cpu_seconds_per_task": (runs[0]["worker_cpu_seconds"] - sum(costs)) / COUNT,
            "store_seconds_per_result": keeping(folder / "store-2", json.loads(result.read_text())),
            "result_bytes": sum(sizes) / len(sizes),
            "costs_cpu_seconds": [round(one, 5) for one in costs],
        }
    (Path(__file__).parent / "measured.json").write_text(json.dumps(measured, indent=1) + "\n")
    print(json.dumps({key: value for key, value in measured.items() if key != "costs_cpu_seconds"}, indent=1))
