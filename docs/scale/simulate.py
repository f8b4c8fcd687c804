"""What a fleet needs on many cores, from the costs that measure.py found: workers, one scheduler, one store.

    python docs/scale/simulate.py [BRIDGES] [CORES]

Costs of bridges are drawn from those measured. A block of tasks passes through the scheduler, which does one thing at a time; a worker reads and computes
its tasks one after the other; each result passes through the store, which takes so many at a time. Two blocks for each worker are under way, as
in extrados.cluster: a worker waits only where both are late. Nothing else is modelled: no network, no start of workers, no failures.
"""

import heapq
import json
import random
import sys
from bisect import bisect_right
from collections import deque
from dataclasses import dataclass
from itertools import accumulate
from pathlib import Path


@dataclass(frozen=True)
class Costs:
    """What was measured [s]."""

    tasks: list[float]
    """Of each task: its analysis."""
    scheduler_per_block: float
    worker_per_block: float
    worker_per_task: float
    store_per_result: float
    """Of a result, as long as nobody else writes."""


@dataclass(frozen=True)
class Found:
    """What came of it."""

    makespan: float
    """From the first block to the last result [s]."""
    efficiency: float
    """Seconds of analyses over seconds of cores."""
    scheduler: float
    """Share of the time in which the scheduler works."""
    store: float
    """Share of the time in which the store works, of what it can take at once."""
    tail: float
    """Share of the time from when the first worker has nothing left to do."""
    blocks: int


def fixed(size):
    """Blocks of one size."""
    return lambda waiting, workers, mean: size


def guided(scheduler, seconds=1.0, ahead=2):
    """Blocks as extrados.cluster cuts them: of about so long, no more than a fair share of what is left, and no shorter than the scheduler can keep up
    with."""

    def size(waiting, workers, mean):
        fair = min(waiting // (2 * ahead * workers), int(seconds / mean))
        kept_up = min(int(2.0 * scheduler * workers / mean), waiting // workers)
        return max(1, fair, kept_up)

    return size


def by_cost(tasks, scheduler, seconds=1.0, ahead=2):
    """The same with costs that are known beforehand, as a model of them would give: blocks of equal time, and not of equal count."""
    sums = [0.0, *accumulate(tasks)]

    def size(waiting, workers, mean):
        begin = len(tasks) - waiting
        left = sums[-1] - sums[begin]
        target = max(min(seconds, left / (2 * ahead * workers)), min(2.0 * scheduler * workers, left / workers))
        return max(1, bisect_right(sums, sums[begin] + target) - 1 - begin)

    return size


def simulate(tasks, workers, costs, size, at_once=64, ahead=2):
    """Lets the workers do the tasks, in their order; `size` says how many go into the next block."""
    mean = sum(tasks) / len(tasks) + costs.worker_per_task
    scheduler_free, blocks, next_task = 0.0, 0, 0
    store = [0.0] * at_once
    held = [deque() for _ in range(workers)]  # Blocks at a worker or on their way to it: when they come, and their tasks.
    last = [0.0] * workers
    # What happens next: when, to which worker, and whether an analysis ends (or the worker looks for something to do).
    events = [(0.0, worker, False) for worker in range(workers)]

    def ask(now, worker):
        """The next block for a worker, through the scheduler."""
        nonlocal scheduler_free, blocks, next_task
        if next_task >= len(tasks):
            return
        count = size(len(tasks) - next_task, workers, mean)
        block = deque(tasks[next_task : next_task + count])
        next_task, blocks = next_task + count, blocks + 1
        scheduler_free = max(scheduler_free, now) + costs.scheduler_per_block
        held[worker].append((scheduler_free + costs.worker_per_block, block))

    for _ in range(ahead):
        for worker in range(workers):
            ask(0.0, worker)
    while events:
        now, worker, ended = heapq.heappop(events)
        if ended:  # An analysis: its result goes to the store, and then the worker is free.
            now = max(now, heapq.heappop(store)) + costs.store_per_result
            heapq.heappush(store, now)
            last[worker] = now
            if not held[worker][0][1]:
                held[worker].popleft()
                ask(now, worker)
        if held[worker]:
            come, block = held[worker][0]
            heapq.heappush(events, (max(now, come) + block.popleft() + costs.worker_per_task, worker, True))
    end = max(last)
    return Found(
        makespan=end,
        efficiency=sum(tasks) / (workers * end),
        scheduler=blocks * costs.scheduler_per_block / end,
        store=len(tasks) * costs.store_per_result / (at_once * end),
        tail=(end - min(last)) / end,
        blocks=blocks,
    )


def measured():
    """The costs that stand beside this file."""
    found = json.loads((Path(__file__).parent / "measured.json").read_text())
    store = found["store_seconds_per_result"]
    # What a worker spends on a task beside its analysis holds the processor's part of writing the result.
    return Costs(
        found["costs_cpu_seconds"],
        found["scheduler_cpu_seconds_per_block"],
        found["worker_cpu_seconds_per_block"],
        max(found["worker_cpu_seconds_per_task"], 0.0),
        store,
    )


def drawn(costs, count, times=1.0, longest_first=False):
    """So many tasks of the measured costs, or of costs so many times larger."""
    tasks = [times * one for one in random.Random(1).choices(costs.tasks, k=count)]
    return sorted(tasks, reverse=True) if longest_first else tasks


def apart(tasks, workers, costs, size, groups, at_once=64):
    """The same in so many groups, each with a scheduler and its share of the tasks; the slowest counts."""
    parts = [tasks[k::groups] for k in range(groups)]
    found = [simulate(part, workers // groups, costs, size(part), max(1, at_once // groups)) for part in parts]
    end = max(one.makespan for one in found)
    first = min((1.0 - one.tail) * one.makespan for one in found)
    return Found(
        makespan=end,
        efficiency=sum(tasks) / (workers * end),
        scheduler=max(one.scheduler * one.makespan for one in found) / end,
        store=sum(one.store * one.makespan for one in found) / (groups * end),
        tail=(end - first) / end,
        blocks=sum(one.blocks for one in found),
    )


def table(bridges, workers, costs):
    """Cuts and their outcome, as Markdown."""
    lines = ["| each task | cut | blocks | store takes at once | time [s] | efficiency | scheduler busy | store busy | tail |"]
    lines.append("|---|---|---:|---:|---:|---:|---:|---:|---:|")
    mean = sum(costs.tasks) / len(costs.tasks)
    each, second, ten = (fixed(max(1, count)) for count in (1, int(1.0 / mean), int(10.0 / mean)))
    own = guided(costs.scheduler_per_block)
    plain = lambda size: lambda tasks: size
    known = lambda tasks: by_cost(tasks, costs.scheduler_per_block)
    shard = lambda tasks: fixed(len(tasks))
    cases = [
        (1.0, False, "one task a block", plain(each), 1, 64),
        (1.0, False, "blocks of about 1 s", plain(second), 1, 64),
        (1.0, False, "blocks of about 10 s", plain(ten), 1, 64),
        (1.0, False, "extrados.cluster", plain(own), 1, 64),
        (1.0, True, "extrados.cluster with costs", known, 1, 64),
        (1.0, False, "extrados.cluster, 10 schedulers", plain(own), 10, 64),
        (1.0, True, "extrados.cluster with costs, 10 schedulers", known, 10, 64),
        (1.0, True, "the same, a store that takes 10 at once", known, 10, 10),
        (1.0, True, "the same, a store that takes 1000 at once", known, 10, 1000),
        (1.0, False, "a shard for each core, no scheduler", shard, workers, 64 * workers),
        (20.0, False, "one task a block", plain(each), 1, 64),
        (20.0, False, "extrados.cluster", plain(own), 1, 64),
        (20.0, True, "extrados.cluster with costs", known, 1, 64),
        (20.0, True, "extrados.cluster with costs, 10 schedulers", known, 10, 64),
        (20.0, False, "a shard for each core, no scheduler", shard, workers, 64 * workers),
    ]
    for times, longest_first, cut, size, groups, at_once in cases:
        tasks = drawn(costs, bridges, times, longest_first)
        found = apart(tasks, workers, costs, size, groups, at_once)
        shown = "–" if groups == workers else str(at_once)
        shares = [f"{100 * one:.0f} %" for one in (found.efficiency, found.scheduler, found.store, found.tail)]
        if groups == workers:
            shares[1] = shares[2] = "–"
        lines.append(f"| {times * mean:.2f} s | {cut} | {found.blocks} | {shown} | {found.makespan:.1f} | {' | '.join(shares)} |")
    return "\n".join(lines)


if __name__ == "__main__":
    bridges, cores = (int(word) for word in (sys.argv[1:] + ["100000", "1000"][len(sys.argv) - 1 :])[:2])
    print(table(bridges, cores, measured()))
