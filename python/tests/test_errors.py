"""What cannot be done is said by class, code, line and caret; what breaks is named and breaks nothing else."""

import pickle

import extrados
import numpy
import pytest

TINY = extrados.Bridge.example("tiny").text


def test_a_file_with_mistakes_prints_line_and_caret():
    bridge = extrados.Bridge.parse(TINY.replace('rise = "1.0 m"', 'rise = "2.85 GPa"'), name="mine.toml")
    checked = bridge.check()
    assert not checked.is_usable and [one.code for one in checked.errors] == ["B104"]
    with pytest.raises(extrados.BridgeError) as raised:
        bridge.collapse()
    error = raised.value
    assert error.code == "B104" and error.findings[0].line == 8
    text = str(error)
    line = text.splitlines()
    assert line[0] == "error[B104]: expected a length, found a pressure"
    assert line[1].startswith("  mine.toml:8:")
    source, carets = line[2], line[3]
    assert source[carets.index("^") :].startswith('"2.85 GPa"')
    assert carets.count("^") == len('"2.85 GPa"')
    assert "help:" in text
    # As the command has it.
    assert "cannot be used" in str(checked)


def test_the_command_prints_the_same(command, tmp_path):
    import subprocess

    path = tmp_path / "mine.toml"
    path.write_text(TINY.replace('rise = "1.0 m"', 'rise = "2.85 GPa"'))
    printed = subprocess.run([command, "check", str(path)], capture_output=True, text=True, check=False).stderr
    assert str(extrados.Bridge.read(path).check().errors[0]) in printed


def test_the_tree_of_classes():
    assert issubclass(extrados.BridgeError, extrados.Error) and issubclass(extrados.BridgeError, ValueError)
    assert issubclass(extrados.FileError, OSError) and issubclass(extrados.ArgumentError, TypeError)
    assert issubclass(extrados.Interrupted, KeyboardInterrupt) and not issubclass(extrados.Interrupted, Exception)
    with pytest.raises(extrados.FileError) as raised:
        extrados.Bridge.read("no/such/bridge.toml")
    again = pickle.loads(pickle.dumps(raised.value))
    assert type(again) is extrados.FileError and again.code == "F101" and again.findings == raised.value.findings
    with pytest.raises(extrados.SetupError):
        extrados.Bridge.example("tiny").collapse(method="dem")
    with pytest.raises(extrados.RecordsError):
        extrados.Bridge.example("tiny").update()


@pytest.mark.parametrize(
    ("call", "named"),
    [
        (lambda b: b.collapse(method="magic"), "method = 'magic'"),
        (lambda b: b.collapse(method=3), "method = 3"),
        (lambda b: b.collapse(resolution="1 m"), "resolution = '1 m'"),
        (lambda b: b.collapse(resolution=float("nan")), "resolution = nan"),
        (lambda b: b.collapse(tolerance=float("nan")), "tolerance = nan"),
        (lambda b: b.collapse(tolerance="small"), "tolerance = 'small'"),
        (lambda b: b.collapse(step_limit=-1), "step_limit = -1"),
        (lambda b: b.collapse(damping="local:7"), "damping = 'local:7'"),
        (lambda b: b.sweep(step="1 kN"), "step = '1 kN'"),
        (lambda b: b.sweep(colour="red"), "colour"),
        (lambda b: b.respond(speed=45), "speed = 45"),
        (lambda b: b.vary(3), "ranges"),
        (lambda b: b.vary("joint.friction_angle=30deg,40deg", most_runs=0), "most_runs = 0"),
        (lambda b: b.assess(skip=["lunch"]), "skip = "),
        (lambda b: b.compare("other"), "other = 'other'"),
        (lambda b: b.with_(span_1_thickness=float("inf")), "span\\[1\\].thickness = inf"),
        (lambda b: b.with_(span_1_thickness=numpy.array([0.5, 0.6])), "span\\[1\\].thickness = ndarray of shape \\(2,\\) and dtype float64"),
        (lambda b: b.with_(span_1_thickness=None), "span\\[1\\].thickness = None"),
        (lambda b: b.collapse(progress=7), "progress = 7"),
        (lambda b: extrados.Bridge.parse(b"bytes"), "text = b'bytes'"),
        (lambda b: extrados.Bridge.example("no"), "no example 'no'"),
        (lambda b: extrados.Bridge.new(bridge={"width": float("nan")}), "bridge.width = nan"),
    ],
)
def test_arguments_are_refused_by_their_names(call, named):
    with pytest.raises(extrados.ArgumentError, match=named):
        call(extrados.Bridge.example("tiny"))


@pytest.mark.parametrize(
    ("edits", "code"),
    [
        ({"span[1].thickness": "0.6"}, "B102"),
        ({"span[1].thickness": 0.6}, "B102"),
        ({"span[1].thickness": "0.6 kN"}, "B104"),
        ({"span[1].colour": "red"}, "B501"),
        ({"span[9].thickness": "0.6 m"}, "B502"),
        ({"joint.friction_angle": "20deg,30deg"}, "B503"),
    ],
)
def test_edits_are_refused(edits, code):
    with pytest.raises(extrados.BridgeError) as raised:
        extrados.Bridge.example("tiny").with_(edits)
    assert raised.value.code == code and "help" in str(raised.value)


def test_a_wrong_keyword_is_told_what_there_is():
    with pytest.raises(extrados.BridgeError, match="span_1_thickness"):
        extrados.Bridge.example("tiny").with_(span_1_thicknes="0.6 m")


def test_a_block_model_file_is_told_where_it_belongs(root):
    with pytest.raises(extrados.ArgumentError, match="Blocks.read"):
        extrados.Bridge.read(root / "examples/drawing/bridge.toml").collapse()


def test_panics_are_caught_and_named():
    from extrados import _extrados

    for deep in (False, True):
        with pytest.raises(extrados.InternalError, match="a test breaks.*lib.rs"):
            _extrados._break(deep)
    # The interpreter goes on, and so do analyses.
    assert extrados.Bridge.example("tiny").collapse(method="limit").status == "collapsed"


def test_a_bridge_made_of_dictionaries():
    bridge = extrados.Bridge.new(
        bridge={"name": 'A "quoted" name', "width": "3.0 m"},
        masonry={"density": "2200 kg/m^3"},
        joint={"friction_angle": "35 deg", "cohesion": "0 kPa"},
        cover=[{"layer": "fill", "thickness": "0.30 m", "density": "1900 kg/m^3"}],
        dispersal={"rule": "uniform", "slope": "2:1"},
        span=[{"profile": "segmental", "span": "4.0 m", "rise": "1.0 m", "thickness": "0.35 m", "voussoirs": numpy.int64(21)}],
        load=[{"kind": "axle", "axle_force": "100 kN", "contact_length": "0.30 m", "effective_width": "2.5 m", "at": "1/4 of span 1"}],
    )
    assert bridge.check().is_usable, str(bridge.check())
    found = bridge.collapse(method="limit")
    assert found.bridge == 'A "quoted" name'
    tiny = extrados.Bridge.example("tiny").with_({"masonry.compressive_strength": "unlimited"}).collapse(method="limit")
    assert found.last_stable_load_kn_per_m == tiny.last_stable_load_kn_per_m
