"""What a call costs beside its analysis. Times are of the processor, so that other work on the machine does not count."""

import os
import subprocess
import sys
import time

import extrados
from extrados import _extrados

def test_the_overhead_of_a_call():
    repeats = 2000
    _extrados._wait(0.0)
    least = min(_timed(lambda: [_extrados._wait(0.0) for _ in range(repeats)]) for _ in range(3))
    # Beside additions of Python's own in the same run: where two programs share a core, both take twice as long.
    additions = min(_timed(lambda: [sum(range(1000)) for _ in range(repeats)]) for _ in range(3))
    print(f"overhead of a call: {1e6 * least / repeats:.1f} us of the processor, {least / additions:.1f} times a thousand additions")
    # Eight thousand additions are a tenth of a millisecond, less than a hundredth of the shortest analysis.
    assert least < 8 * additions


def _timed(work) -> float:
    begun = time.process_time()
    work()
    return time.process_time() - begun


def test_a_loop_in_python_costs_what_it_costs_in_rust(root):
    path, count = root / "examples/tiny/bridge.toml", 30
    bridge = extrados.Bridge.read(path)

    def in_python() -> float:
        total = 0.0
        for k in range(count):
            edited = bridge.with_({"joint.friction_angle": f"{25.0 + 15.0 * k / count!r} deg"})
            total += edited.collapse(method="limit").last_stable_load_kn_per_m or 0.0
        return total

    def in_rust() -> float:
        return _extrados._limit_loads(path, count)

    # In turn, a part at a time, so that whatever else the machine does falls on both.
    costs = {in_rust: 0.0, in_python: 0.0}
    for _ in range(5):
        sums = set()
        for work in costs:
            begun = time.process_time()
            sums.add(work())
            costs[work] += time.process_time() - begun
        assert len(sums) == 1
    rust, python = costs[in_rust], costs[in_python]
    print(f"{5 * count} limit loads: {rust:.2f} s in Rust, {python:.2f} s in Python, ratio {python / rust:.3f}")
    assert python / rust < 1.3


def test_results_are_the_same_for_any_number_of_threads(root):
    code = 'import extrados; b = extrados.Bridge.example("bridgemill"); print(extrados.threads(), b.collapse(method="dem").last_stable_load_kn_per_m.hex(), b.vary("joint.friction_angle=30deg..40deg:4", method="limit").to_dict()["rows"][2]["outcomes"])'
    told = []
    for threads in ("1", "2"):
        environment = {**os.environ, "EXTRADOS_THREADS": threads}
        done = subprocess.run([sys.executable, "-c", code], env=environment, capture_output=True, text=True, check=True)
        used, *rest = done.stdout.split(maxsplit=1)
        assert used == threads
        told.append(rest)
    assert told[0] == told[1]
