"""What people try first: a folder of results, names that are almost right, a path where a bridge is made."""

import json
import pickle
from pathlib import Path

import pytest

import extrados


def test_a_folder_of_results_has_what_the_command_writes(tmp_path: Path):
    found = extrados.Bridge.example("tiny").collapse(method="limit")
    folder = found.save(tmp_path / "new" / "out")
    names = {str(place.relative_to(folder)) for place in folder.rglob("*") if place.is_file()}
    assert {"result.json", "mechanism.svg", "hinges.csv", "thrust-line.csv", "model.dxf", "paraview/mechanism.vtu"} <= names
    told = json.loads((folder / "result.json").read_text(encoding="utf-8"))
    assert told["last_stable_load_kn_per_m"] == found.last_stable_load_kn_per_m
    assert (folder / "mechanism.svg").read_text(encoding="utf-8") == found.figure("mechanism")
    kept = pickle.loads(pickle.dumps(found)).save(tmp_path / "kept")
    for name in ("result.json", "mechanism.svg", "hinges.csv", "thrust-line.csv"):
        assert (kept / name).read_bytes() == (folder / name).read_bytes(), name
    place = tmp_path / "taken"
    place.touch()
    with pytest.raises(extrados.ArgumentError, match="name a folder"):
        found.save(place)


def test_names_that_are_almost_right_are_answered():
    found = extrados.Bridge.example("tiny").collapse(method="limit")
    with pytest.raises(KeyError, match="did you mean 'mechanism'"):
        found.figures["mechanim"]
    with pytest.raises(KeyError, match="did you mean 'hinges'"):
        found.tables["hinge"]
    assert dict(found.tables) == pickle.loads(pickle.dumps(found.tables))
    with pytest.raises(extrados.ArgumentError, match=r"Bridge\.read"):
        extrados.Bridge("bridge.toml")  # type: ignore[arg-type]
    with pytest.raises(AttributeError, match="umbridgee"):
        extrados.umbridgee  # noqa: B018


def test_blocks_come_from_a_text(root: Path):
    folder = root / "examples" / "drawing"
    drawing = {str(place.relative_to(folder)): place.read_bytes() for place in folder.glob("*.dxf")}
    blocks = extrados.Blocks.parse((folder / "bridge.toml").read_text(encoding="utf-8"), name="bridge.toml", files=drawing)
    assert blocks.collapse(method="limit").status == "collapsed"
