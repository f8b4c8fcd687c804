"""The simulation of many cores, on cases whose answer is known."""

import importlib.util
import json
import sys

import pytest
from conftest import ROOT

FOLDER = ROOT / "docs/scale"


@pytest.fixture(scope="module")
def simulate():
    spec = importlib.util.spec_from_file_location("simulate", FOLDER / "simulate.py")
    assert spec and spec.loader
    module = importlib.util.module_from_spec(spec)
    sys.modules["simulate"] = module
    spec.loader.exec_module(module)
    return module


def costs(simulate, tasks, scheduler=0.0, block=0.0, task=0.0, store=0.0):
    return simulate.Costs(tasks, scheduler, block, task, store)


def test_equal_tasks_without_overhead_leave_nobody_idle(simulate):
    tasks = [0.5] * 400
    for size in (1, 5, 10):
        found = simulate.simulate(tasks, 10, costs(simulate, tasks), simulate.fixed(size))
        assert found.makespan == pytest.approx(20.0) and found.efficiency == pytest.approx(1.0)
        assert found.blocks == 400 // size and found.tail == pytest.approx(0.0)


def test_one_worker_pays_for_everything_one_after_the_other(simulate):
    tasks = [0.1, 0.4, 0.2]
    found = simulate.simulate(tasks, 1, costs(simulate, tasks, task=0.01, store=0.02), simulate.fixed(1))
    assert found.makespan == pytest.approx(0.7 + 3 * 0.03)


def test_a_scheduler_and_a_store_bound_the_time(simulate):
    tasks = [0.001] * 5000
    slow = simulate.simulate(tasks, 1000, costs(simulate, tasks, scheduler=0.01), simulate.fixed(1))
    assert slow.makespan == pytest.approx(5000 * 0.01, rel=0.01) and slow.scheduler > 0.99
    narrow = simulate.simulate(tasks, 1000, costs(simulate, tasks, store=0.1), simulate.fixed(1), at_once=10)
    assert narrow.makespan == pytest.approx(5000 * 0.1 / 10, rel=0.01) and narrow.store > 0.99


def test_the_longest_first_leaves_no_straggler(simulate):
    tasks = [0.1] * 300 + [5.0]
    last = simulate.simulate(tasks, 10, costs(simulate, tasks), simulate.fixed(1))
    first = simulate.simulate(sorted(tasks, reverse=True), 10, costs(simulate, tasks), simulate.fixed(1))
    # 30 short ones each, and then the long one; or the long one, and the short one that waits behind it at the same worker.
    assert last.makespan == pytest.approx(30 * 0.1 + 5.0)
    assert first.makespan == pytest.approx(5.0 + 0.1)


def test_every_cut_does_every_task(simulate):
    dice = [0.01 * (1 + k % 17) for k in range(3000)]
    own = costs(simulate, dice, scheduler=2e-3, task=1e-3)
    for size in (simulate.fixed(7), simulate.guided(2e-3), simulate.by_cost(dice, 2e-3)):
        found = simulate.simulate(dice, 20, own, size)
        assert found.efficiency == pytest.approx(sum(dice) / (20 * found.makespan)) and 0.5 < found.efficiency < 1.0


def test_the_measured_costs_are_there(simulate):
    kept = json.loads((FOLDER / "measured.json").read_text())
    assert len(kept["costs_cpu_seconds"]) == kept["bridges"] == 1000
    assert sum(kept["costs_cpu_seconds"]) == pytest.approx(kept["cpu_seconds_alone"], rel=1e-3)
    assert simulate.table(2000, 50, simulate.measured()).count("\n") > 10
