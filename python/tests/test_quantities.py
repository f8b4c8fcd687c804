"""Values of quantities: texts, numbers with a heading, arrays, quantities of pint; and ranges of them."""

import re

import extrados
import numpy
import pytest


@pytest.fixture(scope="module")
def tiny():
    return extrados.Bridge.example("tiny")


@pytest.fixture(scope="module")
def units():
    return pytest.importorskip("pint").UnitRegistry()


class Stand_in:
    """What is asked of a quantity, and no more."""

    def __init__(self, magnitude, units):
        self.magnitude, self.units = magnitude, units

    def to(self, units):
        raise TypeError(units)


# ---- one value


def test_a_heading_has_the_unit_of_numbers(tiny):
    text = tiny.with_({"span[1].thickness": "0.45 m"})
    assert tiny.with_({"span[1].thickness [m]": 0.45}) == text == tiny.with_({"span[1].thickness [m]": numpy.float64(0.45)})
    assert tiny.with_({"span[1].thickness [mm]": 450}).collapse(method="limit") == text.collapse(method="limit")
    assert tiny.with_({"span[1].thickness [m]": "450 mm"}) == tiny.with_(span_1_thickness="450 mm")
    with pytest.raises(extrados.BridgeError, match="length"):
        tiny.with_({"span[1].thickness [deg]": 30})


def test_quantities_of_pint(tiny, units):
    assert tiny.with_(span_1_thickness=0.45 * units.m) == tiny.with_(span_1_thickness="0.45 m")
    assert tiny.with_(span_1_thickness=units.Quantity(numpy.float64(0.45), "m")) == tiny.with_(span_1_thickness="0.45 m")
    assert tiny.with_({"joint.friction_angle": 30 * units.degree}) == tiny.with_(joint_friction_angle="30.0 deg")
    assert tiny.with_(masonry_density=units("22 kN/m**3")) == tiny.with_(masonry_density="22.0 kN/m^3")
    # A unit that bridge files do not have, in that of SI.
    assert tiny.with_(span_1_thickness=units.Quantity(5, "decimeter")) == tiny.with_(span_1_thickness="0.5 m")
    assert tiny.sweep(step=0.5 * units.m, method="limit") == tiny.sweep(step="0.5 m", method="limit")
    assert tiny.key("sweep", step=0.5 * units.m) == tiny.key("sweep", step="0.5 m")
    sections = {"bridge": {"name": "New", "width": 3 * units.m}, "masonry": {"density": 2200 * units("kg/m**3")}}
    text = extrados.Bridge.new(**sections).text
    assert '"3.0 m"' in text and '"2200.0 kg/m^3"' in text


def test_quantities_that_do_not_fit(tiny, units):
    with pytest.raises(extrados.BridgeError, match="expected a length"):
        tiny.with_(span_1_thickness=3 * units.MPa)
    with pytest.raises(extrados.ArgumentError, match="span.1..thickness = 3 volt"):
        tiny.with_(span_1_thickness=3 * units.volt)
    with pytest.raises(extrados.ArgumentError, match="has 2 values"):
        tiny.with_(span_1_thickness=numpy.array([0.4, 0.5]) * units.m)
    with pytest.raises(extrados.ArgumentError, match="= nan"):
        tiny.with_(span_1_thickness=float("nan") * units.m)
    with pytest.raises(extrados.ArgumentError, match="step = "):
        tiny.sweep(step=3 * units.deg)


def test_what_behaves_like_a_quantity_is_one(tiny):
    assert tiny.with_(span_1_thickness=Stand_in(0.45, "m")) == tiny.with_(span_1_thickness="0.45 m")
    with pytest.raises(extrados.ArgumentError, match="has the unit parsec"):
        tiny.with_(span_1_thickness=Stand_in(0.45, "parsec"))


def test_units_that_are_written_alike_are_as_large(root, units):
    """Every unit that goes through as it is written has the size that bridge files give it."""
    from extrados import _units

    source = (root / "crates/bridge/src/quantity.rs").read_text()
    known = {"std::f64::consts::PI": str(numpy.pi)}
    for name, value in re.findall(r"const (\w+): f64 = ([^;]+);", source):
        known[name] = f"({value.replace('_', '') if value[0].isdigit() and '*' not in value else value})"

    def number(expression):
        while names := [one for one in known if re.search(rf"\b{one}\b", expression)]:
            for one in names:
                expression = re.sub(rf"\b{one}\b", known[one], expression)
        return eval(expression)  # Arithmetic of the clone's own source.

    table = source.split("pub const UNITS")[1].split("];")[0]
    sizes = {symbol: (dimension, number(size)) for symbol, dimension, size in re.findall(r'unit\("([^"]+)", Dimension::(\w+), (.+)\),\n', table)}
    assert len(_units._ALIKE) > 50 and _units._ALIKE <= sizes.keys()
    for symbol in _units._ALIKE:
        dimension, size = sizes[symbol]
        own = units.Quantity(1.0, symbol.replace("^", "**")).to_base_units()
        if dimension == "Density" and own.check("[force]/[volume]"):
            size *= number("USUAL_GRAVITY")
        if dimension == "Stress" or dimension == "JointStiffness":
            assert own.check("[pressure]") or own.check("[pressure]/[length]"), symbol
        assert own.magnitude == pytest.approx(size, rel=1e-9), symbol
    for theirs, ours in _units._SI:
        assert units.Quantity(1.0, theirs).to_base_units().magnitude == pytest.approx(sizes[ours][1], rel=1e-12), ours


# ---- ranges


def outcomes(study):
    return [(row["values"], row["outcomes"]) for row in study.rows]


def test_ranges_in_every_form(tiny, units):
    asked = outcomes(tiny.vary("joint.friction_angle=30deg..40deg:3", method="limit"))
    angles = numpy.linspace(30.0, 40.0, 3)
    forms = {
        "dictionary of a range": tiny.vary({"joint.friction_angle": "30deg..40deg:3"}, method="limit"),
        "dictionary of texts": tiny.vary({"joint.friction_angle": ["30 deg", "35 deg", "40 deg"]}, method="limit"),
        "array with a heading": tiny.vary({"joint.friction_angle [deg]": angles}, method="limit"),
        "numbers with a heading": tiny.vary({"joint.friction_angle [deg]": (30, 35, 40)}, method="limit"),
        "keyword": tiny.vary(joint_friction_angle="30deg..40deg:3", method="limit"),
        "keyword of texts": tiny.vary(joint_friction_angle=["30 deg", "35 deg", "40 deg"], method="limit"),
        "array of pint": tiny.vary(joint_friction_angle=angles * units.deg, method="limit"),
        "list of pint": tiny.vary({"joint.friction_angle": [one * units.deg for one in angles]}, method="limit"),
    }
    assert len(asked) == 3
    for form, study in forms.items():
        assert outcomes(study) == asked, form


def test_several_ranges_make_a_grid(tiny):
    thicknesses = numpy.array([0.4, 0.45])
    study = tiny.vary({"span[1].thickness [m]": thicknesses}, "joint.friction_angle=30deg,35deg", joint_cohesion=["0 kPa"], grid=True, method="limit")
    assert [one["quantity"] for one in study.quantities] == ["span[1].thickness", "joint.friction_angle", "joint.cohesion"]
    assert sorted({row["values"]["span[1].thickness"] for row in study.rows}) == [0.4, 0.45] and len(study.rows) >= 4
    one = tiny.vary({"span[1].thickness": "0.45 m"}, method="limit")
    own = tiny.with_({"span[1].thickness": "0.45 m"}).collapse(method="limit")
    assert one.rows[-1]["outcomes"]["last_stable_load_kn_per_m"] == own.last_stable_load_kn_per_m


def test_ranges_that_cannot_be_used(tiny, units):
    for ranges, told in (
        ({"joint.friction_angle [deg]": numpy.ones((2, 2))}, r"joint.friction_angle \[deg\] has values of the shape \(2, 2\)"),
        ({"joint.friction_angle": []}, "joint.friction_angle has no values"),
        ({"joint.friction_angle": ["30 deg,40 deg"]}, "'30 deg,40 deg' among its values"),
        ({"joint.friction_angle [deg]": [30.0, float("nan")]}, "= nan"),
        ({"joint.friction_angle": [None]}, "= None"),
        (3, "ranges = 3 cannot be used"),
    ):
        with pytest.raises(extrados.ArgumentError, match=told):
            tiny.vary(ranges, method="limit")
    with pytest.raises(extrados.Error, match="unit"):
        tiny.vary({"joint.friction_angle": numpy.array([30.0, 40.0])}, method="limit")
    with pytest.raises(extrados.BridgeError, match="joint.frictoin"):
        tiny.vary({"joint.frictoin": ["30 deg"]}, method="limit")


def test_arguments_that_are_nearly_right(tiny):
    with pytest.raises(extrados.ArgumentError, match="there is no argument metod.*\n.*did you mean method"):
        tiny.vary("joint.friction_angle=30deg,40deg", metod="limit")
    with pytest.raises(extrados.ArgumentError, match="there is no argument joint_frictoin_angle.*\n.*joint_friction_angle"):
        tiny.vary(joint_frictoin_angle=["30 deg"], method="limit")
