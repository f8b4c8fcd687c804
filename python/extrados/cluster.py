"""Many analyses over many processes and machines, on Dask: `pip install "extrados[cluster]"`.

```
from extrados import cluster
report = cluster.fleet(sorted(Path("bridges").glob("*.toml")), "collapse", store="results", method="limit")
report.to_pandas()
```

Every task is an analysis of one bridge. Its result is a file of the store, named by the hash of everything that its numbers follow from: the meaning
of the bridge file, the analysis, the options and this build. Each worker writes it as soon as it is finished, whole or not at all, so that a worker
that is killed, a scheduler that is killed or a second call repeat nothing that was finished. Results are not gathered: the report is a Parquet file
written in batches. A bridge file that cannot be used is a row with its reason, and the run goes on.

Tasks travel in blocks: one at a time until some are measured, then as many as take about a second, and fewer towards the end, so that neither the
scheduler nor the last block is waited for. Two blocks for each worker are under way; the rest wait here, and not in the scheduler. Where tasks differ
much, give their `costs`, in any unit, such as the seconds of a coarse first pass: the longest go first, and blocks are of equal time.

```
coarse = cluster.fleet(paths, "sweep", store="coarse", step="2 m")
report = cluster.fleet(paths, "sweep", store="fine", step="0.1 m", costs=coarse.to_pandas()["seconds"])
```

Where the scheduler is lost, the run waits for it and for workers, and goes on.

Without `client` a cluster of local processes is started, one for each core, each with one thread; a `dask.distributed.Client` of any other cluster
(SLURM through dask-jobqueue, Kubernetes) is used as it is, with a store that all of its machines see.
"""

from __future__ import annotations

import json
import os
import time
from collections import deque
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import CancelledError
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from .bridge import Bridge
from .errors import Error, argument

__all__ = ["Report", "fleet", "vary"]

_ANALYSES = ("assess", "cases", "collapse", "respond", "sweep", "update")
_BATCH = 1000
_LOOK = 5.0
"""How often workers are counted [s]: more may come."""
_AHEAD = 2
"""Blocks under way for each worker."""
_BLOCK_SECONDS = 1.0
"""What a block is meant to take [s], where that is no more than a fair share of what is left."""
_TAKEN_UP_SECONDS = 0.01
"""What a task takes whose result is in the store [s]: reading its file, and the result."""
_SCHEDULER_SECONDS = 2.5e-3
"""What the scheduler needs for a block [s], measured: with many workers blocks are longer, so that it keeps up with them."""


@dataclass(frozen=True)
class Report:
    """What came of many analyses."""

    path: Path
    """The Parquet file: a row for each task, in the order in which they were asked for."""
    tasks: int
    computed: int
    """Tasks that this call computed."""
    taken_up: int
    """Tasks whose results were in the store: from an earlier call, another task with the same meaning, or a worker that was lost."""
    failed: list[tuple[str, str]]
    """Name and reason of each task that could not be done."""

    def to_pandas(self) -> Any:
        """The rows as a data frame of pandas."""
        import pandas

        return pandas.read_parquet(self.path)

    def result(self, key: str) -> dict[str, Any]:
        """The whole object of a task, by the `key` of its row."""
        return json.loads((self.path.parent / "results" / f"{key}.json").read_text(encoding="utf-8"))


def fleet(
    bridges: Sequence[str | os.PathLike[str] | Bridge],
    analysis: str = "collapse",
    *,
    store: str | os.PathLike[str],
    client: Any = None,
    costs: Sequence[float] | None = None,
    patience: float = 300.0,
    **options: Any,
) -> Report:
    """An analysis of every bridge: paths of files, or bridges. Options are those of the analysis.

    `costs` says how long each takes beside the others. A scheduler that is lost, and the first worker, are waited for as long as `patience` [s]; what is not done then is named in the report.
    """
    if analysis not in _ANALYSES:
        raise argument(f"analysis = {analysis!r} cannot be used", f"write one of {', '.join(_ANALYSES)}")
    tasks = []
    for number, one in enumerate(bridges):
        if isinstance(one, Bridge):
            tasks.append((f"{number}: {one.name}", one))
        else:
            tasks.append((os.fspath(one), os.path.abspath(one)))
    return _run(tasks, analysis, Path(store), client, costs, patience, options)


def vary(
    bridge: Bridge,
    values: Sequence[Mapping[str, Any]],
    analysis: str = "collapse",
    *,
    store: str | os.PathLike[str],
    client: Any = None,
    costs: Sequence[float] | None = None,
    patience: float = 300.0,
    **options: Any,
) -> Report:
    """An analysis of a bridge with each of these sets of values, as :meth:`extrados.Bridge.with_` takes them: samples, a grid, a design."""
    if analysis not in _ANALYSES:
        raise argument(f"analysis = {analysis!r} cannot be used", f"write one of {', '.join(_ANALYSES)}")
    tasks = [(json.dumps(dict(one), default=str), (bridge, dict(one))) for one in values]
    return _run(tasks, analysis, Path(store), client, costs, patience, options)


def _run(
    tasks: list[tuple[str, Any]],
    analysis: str,
    store: Path,
    client: Any,
    costs: Sequence[float] | None,
    patience: float,
    options: dict[str, Any],
) -> Report:
    if not tasks:
        raise argument("there is nothing to do", "give at least one bridge")
    known = [1.0] * len(tasks) if costs is None else [float(one) for one in costs]
    if len(known) != len(tasks) or not all(0.0 <= one < float("inf") for one in known):
        raise argument(f"costs = {len(known)} numbers cannot be used", f"give one number for each of {len(tasks)} tasks, 0 or more")
    (store / "results").mkdir(parents=True, exist_ok=True)
    with _connected(client) as cluster:
        done = _Crew(cluster, tasks, known, (analysis, options, str(store / "results")), patience).work()
    path = store / "report.parquet"
    _write(done, path)
    failed = [(one["name"], one["reason"]) for one in done if one["reason"]]
    computed = sum(one["computed"] for one in done)
    return Report(path, len(tasks), computed, len(tasks) - computed - len(failed), failed)


class _Crew:
    """Tasks on their way through a cluster."""

    def __init__(
        self, client: Any, tasks: list[tuple[str, Any]], costs: list[float], how: tuple[str, dict[str, Any], str], patience: float
    ) -> None:
        self.client, self.tasks, self.how, self.patience = client, tasks, how, patience
        # What takes long goes first; what takes as long stays in its order. Nothing is free.
        least = 1e-3 * max(costs) or 1.0
        self.costs = [max(one, least) for one in costs]
        self.waiting = deque(sorted(range(len(tasks)), key=lambda number: -self.costs[number]))
        # Tasks of a block that broke go one by one; one that was then lost with its workers goes with nothing beside it: Dask blames every task that
        # a lost worker had been given.
        self.alone: set[int] = set()
        self.apart: set[int] = set()
        self.left = sum(self.costs)
        self.flying: dict[Any, list[int]] = {}
        self.rows: dict[int, dict[str, Any]] = {}
        self.workers, self.most, self.counted = 0, 0, 0.0
        # Tasks that are done: how many, their seconds, and their costs.
        self.count, self.seconds, self.cost = 0, 0.0, 0.0

    def work(self) -> list[dict[str, Any]]:
        """A row for each task, in the order of the tasks."""
        from dask.distributed import wait

        while self.waiting or self.flying:
            if not self.flying and not self._has_workers():
                break
            if time.monotonic() > self.counted + _LOOK:
                self._count_workers()
            # What is sent to a scheduler that is lost is never heard of again.
            while self.waiting and self._may_send() and self.client.status == "running":
                block = self._block()
                # Retried where a worker breaks over it, and not where it was lost: then Dask itself tries again.
                future = self.client.submit(_several, [self.tasks[one] for one in block], *self.how, pure=False, retries=2)
                self.flying[future] = block
            if not self.flying:
                continue
            try:
                wait(list(self.flying), timeout=_LOOK, return_when="FIRST_COMPLETED")
            except CancelledError:  # Told below, block by block.
                pass
            except TimeoutError:
                if not self._count_workers() and not self._has_workers():
                    break
            for future in [one for one in self.flying if one.done()]:
                self._take(future, self.flying.pop(future))
                future.release()
        self._give_up()
        return [self.rows[number] for number in range(len(self.tasks))]

    def _may_send(self) -> bool:
        """Whether another block may be sent beside those that are on their way."""
        if not self.flying:
            return True
        parted = self.waiting[0] in self.apart or any(block[0] in self.apart for block in self.flying.values())
        return not parted and len(self.flying) < _AHEAD * max(self.workers, 1)

    def _block(self) -> list[int]:
        """The next tasks: as many as take about a second, and no more than a fair share of what is left."""
        block = [self.waiting.popleft()]
        taken = self.costs[block[0]]
        if self.count >= max(self.workers, 1) and block[0] not in self.alone:
            size = self._block_seconds() / max(self.seconds / self.cost, 1e-6)
            while self.waiting and self.waiting[0] not in self.alone and taken + self.costs[self.waiting[0]] <= size:
                block.append(self.waiting.popleft())
                taken += self.costs[block[-1]]
        self.left -= taken
        return block

    def _block_seconds(self) -> float:
        """What the next block is to take [s]."""
        workers = max(self.workers, 1)
        left = max(self.left, 0.0) * self.seconds / self.cost
        fair = min(_BLOCK_SECONDS, left / (2 * _AHEAD * workers))
        return max(fair, min(2.0 * _SCHEDULER_SECONDS * workers, left / workers))

    def _take(self, future: Any, block: list[int]) -> None:
        try:
            found = future.result()
        except CancelledError:  # The scheduler was lost with all that it knew.
            self._again(block)
            self.waiting.extendleft(reversed(block))
        except Exception as error:  # The block broke, or lost, every worker that took it up.
            if len(block) > 1:
                self._again(block)
                # Each by itself, and last: whichever it is harms nothing else.
                self.alone.update(block)
                self.waiting.extend(block)
            elif type(error).__name__ == "KilledWorker" and block[0] not in self.apart:
                self._again(block)
                self.alone.update(block)
                self.apart.update(block)
                self.waiting.extend(block)
            else:
                self.rows[block[0]] = _row(self.tasks[block[0]][0], "", "failed", f"{type(error).__name__}: {error}", False)
        else:
            self.rows.update(zip(block, found))
            self.count += len(block)
            self.seconds += sum(row["seconds"] if row["computed"] else _TAKEN_UP_SECONDS for row in found)
            self.cost += sum(self.costs[number] for number in block)

    def _again(self, block: list[int]) -> None:
        self.left += sum(self.costs[one] for one in block)

    def _has_workers(self) -> bool:
        """Waits for the scheduler, where it was lost, and for a worker."""
        end = time.monotonic() + self.patience
        while self.client.status not in ("closed", "closing") and not self._count_workers():
            if time.monotonic() > end:
                return False
            time.sleep(0.1)
        return self.workers > 0

    def _count_workers(self) -> int:
        try:
            threads = self.client.nthreads() if self.client.status == "running" else {}
        except OSError:  # The scheduler was lost just now.
            threads = {}
        self.workers, self.counted = sum(threads.values()), time.monotonic()
        self.most = max(self.most, len(threads))
        if not threads and self.most and hasattr(self.client.cluster, "scale"):
            # A nanny that was killed with its worker, or gave up, starts none again.
            self.client.cluster.scale(self.most)
        return self.workers

    def _give_up(self) -> None:
        """Names what is not done."""
        reason = "the scheduler or all workers were lost; the same call goes on from what is in the store"
        for number in set(range(len(self.tasks))) - self.rows.keys():
            self.rows[number] = _row(self.tasks[number][0], "", "failed", reason, False)


@contextmanager
def _connected(client: Any) -> Iterator[Any]:
    if client is not None:
        yield client
        return
    import dask.config as settings_of_dask
    from dask.distributed import Client, LocalCluster

    # For this machine alone, and without the profile of every worker, which takes a thirtieth of a core.
    settings: dict[str, Any] = {"threads_per_worker": 1, "dashboard_address": "127.0.0.1:0", "host": "127.0.0.1"}
    with (
        settings_of_dask.set({"distributed.worker.profile.enabled": False}),
        LocalCluster(n_workers=os.cpu_count() or 1, **settings) as cluster,
        Client(cluster) as own,
    ):
        yield own


def _row(name: str, key: str, status: str, reason: str, computed: bool) -> dict[str, Any]:
    return {"name": name, "key": key, "status": status, "reason": reason, "computed": computed, "seconds": 0.0}


def _several(tasks: list[tuple[str, Any]], analysis: str, options: dict[str, Any], store: str) -> list[dict[str, Any]]:
    """A block of tasks, on a worker: as many threads compute as the worker has, and not as many as its machine."""
    from dask.distributed import get_worker

    os.environ.setdefault("EXTRADOS_THREADS", str(get_worker().state.nthreads))
    return [_one(name, what, analysis, options, store) for name, what in tasks]


def _one(name: str, what: Any, analysis: str, options: dict[str, Any], store: str) -> dict[str, Any]:
    """A task, on a worker: takes up its result, or computes and keeps it."""
    try:
        if isinstance(what, str):
            bridge = Bridge.read(what)
        elif isinstance(what, tuple):
            bridge = what[0].with_(what[1])
        else:
            bridge = what
        key = bridge.key(analysis, **options)
        path = Path(store) / f"{key}.json"
        try:
            found = json.loads(path.read_text(encoding="utf-8"))
            computed = False
        except (OSError, ValueError):
            found = getattr(bridge, analysis)(**options).to_dict()
            _keep(path, found)
            computed = True
    except Error as error:
        first = next((one for one in error.findings if one.severity == "error"), None)
        place = f"line {first.line}: " if first and first.line else ""
        return _row(name, "", "refused", f"{place}{first.message} ({first.code})" if first else str(error), False)
    except OSError as error:
        return _row(name, "", "failed", f"{type(error).__name__}: {error}", False)
    row = _row(name, key, found["status"], "", computed)
    row["seconds"] = found["wall_seconds"]
    numbers = {**found, **{f"governing_{k}": v for k, v in (found.get("governing") or {}).items()}} if analysis != "assess" else found
    row |= {k: float(v) for k, v in numbers.items() if isinstance(v, (int, float)) and not isinstance(v, bool) and k not in row}
    return row


def _keep(path: Path, found: dict[str, Any]) -> None:
    """Writes a result whole or not at all."""
    import tempfile

    handle, temporary = tempfile.mkstemp(dir=path.parent, suffix=".part")
    try:
        with os.fdopen(handle, "w", encoding="utf-8") as file:
            json.dump(found, file)
            file.flush()
            os.fsync(file.fileno())
        os.replace(temporary, path)
    except BaseException:
        if os.path.exists(temporary):
            os.unlink(temporary)
        raise


def _write(rows: list[dict[str, Any]], path: Path) -> None:
    import pyarrow
    import pyarrow.parquet

    kinds = {"name": pyarrow.string(), "key": pyarrow.string(), "status": pyarrow.string(), "reason": pyarrow.string()}
    kinds |= {"computed": pyarrow.bool_(), "seconds": pyarrow.float64()}
    for row in rows:
        kinds |= {name: pyarrow.float64() for name in row if name not in kinds}
    schema = pyarrow.schema(list(kinds.items()))
    temporary = path.with_suffix(".part")
    with pyarrow.parquet.ParquetWriter(temporary, schema) as writer:
        for start in range(0, len(rows), _BATCH):
            batch = rows[start : start + _BATCH]
            columns = [pyarrow.array([row.get(name) for row in batch], kind) for name, kind in kinds.items()]
            writer.write_table(pyarrow.Table.from_arrays(columns, schema=schema))
    os.replace(temporary, path)
