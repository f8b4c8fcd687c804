"""Runs in the hands of their caller end where undisturbed ones do."""

import extrados
import numpy


def test_a_collapse_can_be_stepped():
    bridge = extrados.Bridge.example("bridgemill")
    run = bridge.collapse_run(method="dem")
    looks = 0
    while run.advance(7001) is None:
        looks += 1
        frame = run.frame()
        assert frame.centres_m.shape[1] == 2 and numpy.isfinite(frame.stresses_pa).all()
    ended = run.finish()
    whole = bridge.collapse(method="dem")
    assert looks > 10
    assert ended.last_stable_load_kn_per_m == whole.last_stable_load_kn_per_m
    assert ended.collapse_load_kn_per_m == whole.collapse_load_kn_per_m


def test_a_passage_can_be_stepped(small_passage):
    run = small_passage.passage_run()
    assert run.place is None
    seen = []
    while run.advance(1) is None:
        seen.append(run.values_si)
        assert run.moment().displacements_m.shape[1] == 2
    stepped, whole = run.finish(), small_passage.respond()
    assert len(seen) >= run_length(whole) - 1
    for name, record in whole.records.items():
        assert numpy.array_equal(record.values_si, stepped.records[name].values_si)


def run_length(passage) -> int:
    return len(passage.times_s)


def test_a_run_that_has_ended_says_so():
    import pytest

    run = extrados.Bridge.example("bridgemill").collapse_run(method="dem")
    run.finish()
    for call in (run.frame, run.finish, lambda: run.load_kn_per_m):
        with pytest.raises(extrados.ArgumentError, match="has ended"):
            call()
    with pytest.raises(extrados.ArgumentError, match="steps = 0"):
        run.advance(0)
