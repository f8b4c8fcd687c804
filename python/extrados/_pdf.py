"""Drawings as PDF, by matplotlib where it is installed: lines and text stay lines and text. Drawings use few elements of SVG, and one that is not known
here is refused."""

from __future__ import annotations

import io
import re
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any
from xml.etree import ElementTree

from .errors import argument

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_POINTS_PER_MM = 72.0 / 25.4
_NAMESPACE = "{http://www.w3.org/2000/svg}"
_KNOWN = frozenset(
    "class clip-path cx cy d fill font-family font-size font-weight height id paint-order points r stroke stroke-dasharray stroke-linecap "
    "stroke-linejoin stroke-width text-anchor viewBox width x y".split()
)
_INHERITED = ("fill", "stroke", "stroke-width", "stroke-linejoin", "stroke-linecap", "stroke-dasharray", "clip-path")


def written(svg: str) -> bytes:
    """A drawing as a page of its own size."""
    try:
        import matplotlib
        from matplotlib.backends.backend_pdf import FigureCanvasPdf
    except ImportError:
        help = 'pip install matplotlib, or save it as ".svg" or ".png"'
        raise argument("a drawing becomes PDF by matplotlib, which is not installed", help) from None
    bytes = io.BytesIO()
    # Without the time, so that the same drawing is the same file; with the letters of the font, so that text can be searched.
    with matplotlib.rc_context({"pdf.fonttype": 42}):
        FigureCanvasPdf(page(svg)).print_pdf(bytes, metadata={"CreationDate": None, "Creator": "extrados"})
    return bytes.getvalue()


def page(svg: str) -> Figure:
    """A drawing as a figure of matplotlib."""
    from matplotlib.figure import Figure

    try:
        root = ElementTree.fromstring(svg.encode())
    except ElementTree.ParseError as error:
        raise argument(f"the drawing cannot be read: {error}", "give a drawing as a result has it") from None
    width, height = (float(root.attrib[side].removesuffix("mm")) * _POINTS_PER_MM for side in ("width", "height"))
    left, top, across, down = map(float, root.attrib["viewBox"].split())
    figure = Figure(figsize=(width / 72.0, height / 72.0))
    axes = figure.add_axes((0.0, 0.0, 1.0, 1.0), xlim=(left, left + across), ylim=(top + down, top))
    axes.axis("off")
    _Page(axes, width / across, root).draw(root, {})
    return figure


class _Page:
    """Draws elements of SVG on axes in units of the drawing."""

    def __init__(self, axes: Axes, points_per_unit: float, root: ElementTree.Element) -> None:
        self.axes, self.scale = axes, points_per_unit
        self.order = 0
        self.rooms = {one.attrib["id"]: one[0].attrib for one in root.iter(f"{_NAMESPACE}clipPath")}

    def draw(self, element: ElementTree.Element, above: Mapping[str, str]) -> None:
        style = {**above, **element.attrib}
        kind = element.tag.removeprefix(_NAMESPACE)
        for name in element.attrib.keys() - _KNOWN - ({"transform"} if kind == "text" else set()):
            raise argument(f"a drawing with {name}= of <{kind}> cannot become PDF", 'save it as ".svg" or ".png"')
        if kind in ("svg", "g"):
            for child in element:
                self.draw(child, {name: style[name] for name in _INHERITED if name in style})
        elif kind == "text":
            self._text(element.text or "", style)
        elif kind not in ("clipPath", "title", "desc"):
            self._shape(kind, style)

    def _shape(self, kind: str, style: Mapping[str, str]) -> None:
        from matplotlib.patches import Circle, PathPatch, Rectangle
        from matplotlib.path import Path

        number = {name: float(style.get(name, 0)) for name in ("x", "y", "cx", "cy", "r", "width", "height") if kind in ("rect", "circle")}
        if kind == "rect":
            shape: Any = Rectangle((number["x"], number["y"]), number["width"], number["height"])
        elif kind == "circle":
            shape = Circle((number["cx"], number["cy"]), number["r"])
        elif kind in ("polygon", "polyline"):
            points = [tuple(map(float, pair.split(","))) for pair in style["points"].split()]
            shape = PathPatch(Path([*points, points[0]] if kind == "polygon" else points, closed=kind == "polygon"))
        elif kind == "path":
            shape = PathPatch(_path(style["d"]))
        else:
            raise argument(f"a drawing with <{kind}> cannot become PDF", 'save it as ".svg" or ".png"')
        stroke = style.get("stroke", "none")
        shape.set(
            facecolor=style.get("fill", "black"),
            edgecolor=stroke,
            linewidth=float(style.get("stroke-width", 1)) * self.scale if stroke != "none" else 0.0,
            joinstyle=style.get("stroke-linejoin", "miter"),
            capstyle=style.get("stroke-linecap", "butt"),
        )
        if "stroke-dasharray" in style:
            width = shape.get_linewidth() or 1.0
            # matplotlib gives dashes in widths of their line.
            shape.set_linestyle((0, [float(one) * self.scale / width for one in style["stroke-dasharray"].split()]))
        self._put(shape, style)

    def _text(self, words: str, style: Mapping[str, str]) -> None:
        from matplotlib.patheffects import Normal, Stroke
        from matplotlib.text import Text

        turn = re.fullmatch(r"rotate\((-?[\d.]+) [-\d. ]+\)", style.get("transform", ""))
        if "transform" in style and not turn:
            raise argument(f"a drawing with a text that is moved by {style['transform']} cannot become PDF", 'save it as ".svg" or ".png"')
        anchor: Any = {"middle": "center", "end": "right"}.get(style.get("text-anchor", ""), "left")
        text = Text(
            float(style["x"]),
            float(style["y"]),
            words.replace("$", r"\$"),
            fontsize=float(style["font-size"]) * self.scale,
            fontfamily="DejaVu Sans",
            fontweight=style.get("font-weight", "normal"),
            color=style.get("fill", "black"),
            rotation=-float(turn[1]) if turn else 0.0,
            rotation_mode="anchor",
            horizontalalignment=anchor,
            verticalalignment="baseline",
        )
        if "stroke" in style and style["stroke"] != "none":
            halo = Stroke(linewidth=float(style.get("stroke-width", 1)) * self.scale, foreground=style["stroke"])
            text.set_path_effects([halo, Normal()])
        self._put(text, style)

    def _put(self, artist: Any, style: Mapping[str, str]) -> None:
        self.order += 1
        artist.set_zorder(self.order)
        self.axes.add_artist(artist)
        room = self.rooms.get(style.get("clip-path", "").removeprefix("url(#").removesuffix(")"))
        if room is not None:
            from matplotlib.patches import Rectangle

            x, y, width, height = (float(room[name]) for name in ("x", "y", "width", "height"))
            artist.set_clip_path(Rectangle((x, y), width, height, transform=self.axes.transData))


def _path(text: str) -> Any:
    """Straight lines: `M x y` begins one, `L x y` goes on, `Z` closes it."""
    from matplotlib.path import Path

    points: list[tuple[float, float]] = []
    codes: list[Any] = []
    for letter, numbers in re.findall(r"([A-Za-z])([^A-Za-z]*)", text):
        values = [float(one) for one in numbers.replace(",", " ").split()]
        if letter == "Z":
            points.append(points[-1])
            codes.append(Path.CLOSEPOLY)
        elif letter in "ML":
            for k, point in enumerate(zip(values[::2], values[1::2])):
                points.append(point)
                codes.append(Path.MOVETO if letter == "M" and k == 0 else Path.LINETO)
        else:
            raise argument(f"a drawing with the path {letter!r} cannot become PDF", 'save it as ".svg" or ".png"')
    return Path(points, codes)
