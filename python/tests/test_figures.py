"""Drawings are written as what their names say."""

import builtins
import re
import struct

import extrados
import numpy
import pytest


@pytest.fixture(scope="module")
def drawings(small_passage):
    tiny = extrados.Bridge.example("tiny")
    made = {
        "collapse": extrados.Bridge.example("bridgemill").collapse(method="dem"),
        "sweep": tiny.sweep(step="0.5 m"),
        "vary": tiny.vary("joint.friction_angle=30deg..40deg:3", "span[1].thickness=0.38m..0.42m:3", method="limit"),
        "passage": small_passage.respond(),
        "update": extrados.Bridge.example("update").update(records_only=True),
    }
    return {f"{name} {figure}": drawn for name, found in made.items() for figure, drawn in found.figures.items()}


@pytest.fixture
def drawn():
    return extrados.Bridge.example("tiny").collapse(method="limit").figure("mechanism")


def test_svg(drawn, tmp_path):
    path = drawn.save(tmp_path / "m.svg")
    assert path.read_text() == drawn and path.read_text().startswith("<?xml")


@pytest.mark.parametrize(("asked", "width"), [({}, 2400), ({"width_px": 300}, 300)])
def test_png(drawn, tmp_path, asked, width):
    content = drawn.save(str(tmp_path / "m.PNG"), **asked).read_bytes()
    assert content.startswith(b"\x89PNG\r\n\x1a\n")
    sides = struct.unpack(">II", content[16:24])
    view = [float(one) for one in re.search(r'viewBox="([^"]+)"', drawn)[1].split()]
    assert sides[0] == width and sides[1] == pytest.approx(width * view[3] / view[2], abs=1)


def test_pdf(drawn, tmp_path):
    pytest.importorskip("matplotlib")
    content = drawn.save(tmp_path / "m.pdf").read_bytes()
    assert content.startswith(b"%PDF-") and content.rstrip().endswith(b"%%EOF")
    sides = [float(one) for one in re.search(rb"/MediaBox \[ ?0 0 ([\d.]+) ([\d.]+)", content).groups()]
    asked = [float(side) * 72 / 25.4 for side in re.search(r'width="([\d.]+)mm" height="([\d.]+)mm"', drawn).groups()]
    assert sides == pytest.approx(asked, abs=0.1)
    # The same drawing is the same file.
    assert drawn.save(tmp_path / "again.pdf").read_bytes() == content


def test_a_page_shows_what_the_picture_shows(drawings, tmp_path):
    """Two programs draw every figure: resvg the picture, matplotlib the page. Ink lies where it lies in the other, and not six pixels beside."""
    image = pytest.importorskip("matplotlib.image")
    from extrados import _pdf
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    assert len(drawings) > 10
    for name, one in drawings.items():
        picture = 255.0 * image.imread(one.save(tmp_path / "one.png", width_px=800))[:, :, :3]
        page = _pdf.page(one)
        page.set_dpi(800 / page.get_figwidth())
        canvas = FigureCanvasAgg(page)
        canvas.draw()
        seen = numpy.asarray(canvas.buffer_rgba())[:, :, :3].astype(float)
        height = min(len(seen), len(picture))
        apart, shifted = (numpy.abs(seen[: height - 6] - picture[move : height - 6 + move]).mean() for move in (0, 6))
        assert abs(len(seen) - len(picture)) <= 1 and apart < 0.6 * shifted, name


def test_other_ends_of_names_are_refused(drawn, tmp_path):
    for name, told in (("m.jpg", "as '.jpg'"), ("m", "does not say as what")):
        with pytest.raises(extrados.ArgumentError, match=told) as refusal:
            drawn.save(tmp_path / name)
        assert all(suffix in str(refusal.value) for suffix in (".svg", ".png", ".pdf"))
    for name, width in (("m.svg", 100), ("m.png", 0), ("m.png", 30_000), ("m.png", 2.5), ("m.png", -1), ("m.png", 2**40)):
        with pytest.raises(extrados.ArgumentError, match=f"width_px = {width}"):
            drawn.save(tmp_path / name, width_px=width)
    assert list(tmp_path.iterdir()) == []


def test_pdf_without_matplotlib_says_what_to_do(drawn, tmp_path, monkeypatch):
    real = builtins.__import__

    def without(name, *rest):
        if name.startswith("matplotlib"):
            raise ImportError(name)
        return real(name, *rest)

    monkeypatch.setattr(builtins, "__import__", without)
    with pytest.raises(extrados.ArgumentError, match=r"not installed\n  help: pip install matplotlib, or save it as \"\.svg\""):
        drawn.save(tmp_path / "m.pdf")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("name", ["m.png", "m.pdf"])
def test_a_text_that_is_no_drawing_is_refused(tmp_path, name):
    pytest.importorskip("matplotlib")
    with pytest.raises(extrados.ArgumentError, match="the drawing cannot be read"):
        extrados.Figure("<svg").save(tmp_path / name)
    assert list(tmp_path.iterdir()) == []


def test_an_element_that_a_page_does_not_know_is_refused_and_not_left_out(drawn, tmp_path):
    pytest.importorskip("matplotlib")
    for element, told in (
        ("<ellipse/>", "<ellipse> cannot become PDF"),
        ('<path d="M0 0C1 1 2 2 3 3"/>', "the path 'C' cannot become PDF"),
        ('<rect width="1" height="1" opacity="0.5"/>', "opacity= of <rect> cannot become PDF"),
        ('<g transform="scale(2)"/>', "transform= of <g> cannot become PDF"),
        ('<text x="1" y="1" font-size="9" transform="scale(2)">a</text>', r"moved by scale\(2\) cannot become PDF"),
    ):
        with pytest.raises(extrados.ArgumentError, match=told):
            extrados.Figure(drawn.replace("</svg>", f"{element}</svg>")).save(tmp_path / "m.pdf")
