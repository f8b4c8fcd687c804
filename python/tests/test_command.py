"""Results are those of the command, to the last bit."""

import inspect
import json
import subprocess
from pathlib import Path

import extrados
import pytest

# What follows from the run and not from the bridge.
ELSEWHERE = {"out", "files", "wall_seconds", "threads"}
TIMES = {"seconds", "cached", "key", "wall_seconds"}
# Minutes, where another example goes the same way.
LONG = {
    *("examples/bridgemill/whole.toml", "examples/bridgemill/case-4.toml"),
    *("examples/prestwood/particles.toml", "examples/prestwood/continuum.toml", "examples/skew-railway/bridge.toml"),
    *("examples/bridgemill/continuum.toml", "examples/defects/bridge.toml"),
}


def by_command(command: str, root: Path, out: Path, *words: str) -> dict:
    run = [command, *words, "--out", str(out), "--json", "--quiet"]
    printed = subprocess.run(run, cwd=root, capture_output=True, text=True, check=False).stdout
    sealed = out / "result.json"
    return json.loads(sealed.read_text() if sealed.exists() else printed)


def plain(value):
    if isinstance(value, dict):
        return {key: plain(one) for key, one in value.items() if key not in TIMES}
    return [plain(one) for one in value] if isinstance(value, list) else value


def same(python: dict, written: dict) -> None:
    own = {key: plain(one) for key, one in python.items() if key not in ELSEWHERE}
    other = {key: plain(one) for key, one in written.items() if key not in ELSEWHERE}
    assert own.keys() == other.keys()
    for key, value in other.items():
        assert own[key] == value, key


def declared(kind: type) -> set[str]:
    return {name for one in kind.__mro__ for name in inspect.get_annotations(one)}


def examples(root: Path) -> list[str]:
    from conftest import ROOT

    names = [str(path.relative_to(ROOT)) for path in sorted(ROOT.glob("examples/*/*.toml"))]
    skipped = ("update", "calibration", "assess", "passage", "second-twin", "vehicles", "vary", "cases")
    return [name for name in names if not Path(name).stem.startswith(skipped) and name not in LONG]


from conftest import ROOT  # noqa: E402


@pytest.mark.parametrize("file", examples(ROOT))
def test_limit_analysis_of_every_example(command, root, tmp_path, monkeypatch, file):
    monkeypatch.chdir(root)
    written = by_command(command, root, tmp_path / "out", "collapse", file, "--method", "limit")
    read = extrados.Blocks.read if "drawing" in file else extrados.Bridge.read
    if written["status"] == "unusable-input":
        # An example of particles, which limit analysis has not.
        with pytest.raises(extrados.Error) as refusal:
            read(file).collapse(method="limit")
        assert refusal.value.code == written["errors"][0]["code"] == "F108"
        return
    found = read(file).collapse(method="limit")
    own = found.to_dict()
    if "drawing" in file:
        own.pop("warnings"), written.pop("warnings"), written.pop("notes", None)
    same(own, written)
    assert found.status == written["status"]
    assert found.last_stable_load_kn_per_m == written["last_stable_load_kn_per_m"]
    assert declared(extrados.Collapse) >= own.keys()


def test_other_methods(command, root, tmp_path, monkeypatch):
    monkeypatch.chdir(root)
    file = "examples/bridgemill/case-1.toml"
    for method in ("dem", "path", "fe"):
        written = by_command(command, root, tmp_path / method, "collapse", file, "--method", method)
        found = extrados.Bridge.read(file).collapse(method=method)
        same(found.to_dict(), written)
        assert declared(extrados.Collapse) >= found.to_dict().keys()
    written = by_command(command, root, tmp_path / "moves", "collapse", "examples/settlement/bridge.toml")
    same(extrados.Bridge.read("examples/settlement/bridge.toml").collapse().to_dict(), written)


def test_sweeps_studies_and_cases(command, root, tmp_path, monkeypatch):
    monkeypatch.chdir(root)
    read = extrados.Bridge.read
    tiny, sweeps, cases = (f"examples/{name}.toml" for name in ("tiny/bridge", "bridgemill/vehicles", "packhorse/cases"))
    written = by_command(command, root, tmp_path / "sweep", "collapse", tiny, "--sweep")
    found = read(tiny).sweep()
    assert isinstance(found, extrados.Sweep)
    same(found.to_dict(), written)
    written = by_command(command, root, tmp_path / "vehicles", "collapse", sweeps, "--sweep")
    found = read(sweeps).sweep()
    assert isinstance(found, extrados.VehicleSweep)
    same(found.to_dict(), written)
    assert found.adequacy_factor == written["governing"]["adequacy_factor"]
    ranges = ["joint.friction_angle=30deg..40deg:3", "masonry.density=x0.9,x1.1"]
    words = [word for one in ranges for word in ("--set", one)]
    written = by_command(command, root, tmp_path / "vary", "vary", tiny, *words)
    found = read(tiny).vary(*ranges)
    same(found.to_dict(), written)
    assert found.runs == 6
    written = by_command(command, root, tmp_path / "cases", "cases", cases)
    found = read(cases).cases()
    same(found.to_dict(), written)
    other = "examples/packhorse/bridge.toml"
    written = by_command(command, root, tmp_path / "compare", "compare", other, cases)
    same(read(other).compare(read(cases)).to_dict(), written)


def test_passage_records_and_assessment(command, root, tmp_path, monkeypatch, small_passage):
    file = tmp_path / "few.toml"
    file.write_text(small_passage.text)
    written = by_command(command, root, tmp_path / "passage", "respond", str(file))
    found = extrados.Bridge.read(file).respond()
    same(found.to_dict(), written)
    assert declared(extrados.Passage) >= found.to_dict().keys()
    monkeypatch.chdir(root)
    update = "examples/railway-arch/update.toml"
    written = by_command(command, root, tmp_path / "records", "update", update, "--records-only")
    found = extrados.Bridge.read(update).update(records_only=True)
    own = found.to_dict()
    assert own.pop("evaluations_taken_up") == 0
    own["status"] = written["status"]
    same(own, written)
    assert declared(extrados.Update) >= own.keys()
    judged = "examples/bridgemill/assess.toml"
    skip = ["vehicles", "sensitivity", "collapse"]
    words = [word for one in skip for word in ("--skip", one)]
    written = by_command(command, root, tmp_path / "assess", "assess", judged, *words)
    found = extrados.Bridge.read(judged).assess(skip=skip)
    same(found.to_dict(), written)
    assert "<html" in found.report_html[:200]
