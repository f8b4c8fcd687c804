"""Ctrl-C ends a call within 0.2 s and leaves what is finished; the same call goes on from there to the same numbers."""

import os
import pickle
import signal
import subprocess
import sys
import threading
import time

import extrados
import pytest
from extrados import _extrados


def interrupted(call, after: float):
    """Sends Ctrl-C to this process while `call` works; gives the exception and how long the end took [s]."""
    sent = []

    def send():
        time.sleep(after)
        sent.append(time.monotonic())
        os.kill(os.getpid(), signal.SIGINT)

    thread = threading.Thread(target=send)
    thread.start()
    with pytest.raises(extrados.Interrupted) as raised:
        call()
    took = time.monotonic() - sent[0]
    thread.join()
    return raised.value, took


def test_a_call_ends_in_time():
    _, took = interrupted(lambda: _extrados._wait(30.0), 0.1)
    assert took < 0.2


def test_work_that_hears_nothing_does_not_hold_the_call():
    tight = extrados.Bridge.example("bridgemill").with_({"analysis.tolerance": 1e-9, "analysis.load_step": "0.5 kN/m"})
    _, took = interrupted(lambda: tight.collapse(method="dem"), 0.5)
    assert took < 0.2


def test_a_collapse_keeps_its_state_and_goes_on():
    bridge = extrados.Bridge.example("bridgemill")
    whole = bridge.collapse(method="dem")
    error = interrupted_collapse(bridge)
    # On a machine that is busy the run may end a little later than the call: its state is waited for.
    assert error.result is None or error.result.status == "cancelled"
    state = pickle.loads(pickle.dumps(error.state))
    found = bridge.collapse(method="dem", resume=state)
    assert found.last_stable_load_kn_per_m == whole.last_stable_load_kn_per_m
    assert found.path == whole.path


def interrupted_collapse(bridge):
    """Stops a run in its midst, whatever the machine's load."""

    def stop(progress):
        if progress.fraction is not None and progress.steps > 3000:
            signal.raise_signal(signal.SIGINT)

    with pytest.raises(extrados.Interrupted) as raised:
        bridge.collapse(method="dem", progress=stop)
    assert raised.value.state is not None
    return raised.value


def test_a_study_keeps_its_finished_runs():
    bridge = extrados.Bridge.example("bridgemill")
    ranges = ["joint.friction_angle=30deg..40deg:12"]
    looks = []

    def stop(progress):
        looks.append(progress)
        if progress.fraction and progress.fraction > 0.3:
            signal.raise_signal(signal.SIGINT)

    with pytest.raises(extrados.Interrupted) as raised:
        bridge.vary(*ranges, method="dem", progress=stop)
    assert looks and "finished pieces" in repr(raised.value.state)
    found = bridge.vary(*ranges, method="dem", resume=raised.value.state)
    assert 0 < found.runs_from_cache < found.runs == 13


def test_the_callback_hears_and_may_end_a_call():
    heard = []
    _extrados._wait(0.2, lambda *told: heard.append(told))
    assert len(heard) >= 2 and heard[-1][1] == "waiting" and 0 < heard[-1][2] <= 1

    class Enough(Exception):
        pass

    def enough(progress):
        raise Enough

    with pytest.raises(Enough):
        extrados.Bridge.example("bridgemill").collapse(method="dem", progress=enough)


def test_other_threads_of_python_go_on():
    ticks, done = [], threading.Event()

    def tick():
        while not done.is_set():
            ticks.append(time.monotonic())
            time.sleep(0.005)

    thread = threading.Thread(target=tick)
    thread.start()
    _extrados._wait(0.5)
    done.set()
    thread.join()
    assert len(ticks) > 20


def test_a_bar_is_drawn(capsys):
    extrados.Bridge.example("bridgemill").collapse(method="dem", progress=True)
    assert capsys.readouterr().out == ""


def test_a_forked_process_computes(root):
    code = """
import os, extrados
first = extrados.Bridge.example("tiny").collapse(method="limit").last_stable_load_kn_per_m
child = os.fork()
if child == 0:
    bridge = extrados.Bridge.example("tiny")
    again = bridge.collapse(method="limit").last_stable_load_kn_per_m
    study = bridge.vary("joint.friction_angle=30deg..40deg:3")
    os._exit(0 if again == first and study.runs == 4 else 1)
assert os.waitpid(child, 0)[1] == 0
"""
    subprocess.run([sys.executable, "-c", code], check=True, timeout=60)
