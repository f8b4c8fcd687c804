"""Loads at rest: what a test would tell, as the command has it, and a file that has none."""

from pathlib import Path

import pytest

import extrados

ROAD = Path(__file__).parents[2] / "examples" / "road-bridge" / "bridge.toml"


def test_a_load_test_is_planned_before_anything_is_read():
    plan = extrados.Bridge.read(ROAD).plan_load_test()
    positions, sensors = plan["positions"], plan["sensors"]
    assert len(positions) == 6 and len(sensors) == 4
    bits = [one["information_bit"] for one in positions]
    assert bits == sorted(bits, reverse=True) and sum(bits) == pytest.approx(plan["information_bit"], abs=0.02)
    for one in plan["parameters"]:
        low, high = plan["interval_95"][one["name"]]
        assert one["range"][0] <= low < one["start"] < high <= one["range"][1]


def test_a_file_without_a_load_test_is_told_what_it_lacks():
    with pytest.raises(extrados.ArgumentError, match="no load test to plan"):
        extrados.Bridge.example("tiny").plan_load_test()
