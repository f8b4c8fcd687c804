#!/usr/bin/env python3
"""Writes the drawings of this folder with ezdxf, another program's library: pip install ezdxf, then run it here.

The tests read the committed files and need no Python. Dates and identifiers are fixed, so that the same version of
ezdxf writes the same bytes (written with 1.4.5).
"""
import math
from pathlib import Path

import ezdxf
from ezdxf import units

ezdxf.options.write_fixed_meta_data_for_testing = True
HERE = Path(__file__).resolve().parent


def new(unit, version="R2010"):
    doc = ezdxf.new(version, units=unit)
    return doc, doc.modelspace()


def save(doc, name):
    doc.saveas(HERE / name)


def closed(space, points, layer, **more):
    return space.add_lwpolyline(points, close=True, dxfattribs={"layer": layer}, **more)


def arch(name, unit, size, faces):
    """Bridgemill, case 1: 62 equal voussoirs over 18.30 m, rise 2.85 m, ring 0.711 m, between two abutments."""
    doc, space = new(unit)
    span, rise, ring, count = 18.30, 2.85, 0.711, 62
    radius = ((span / 2) ** 2 + rise**2) / (2 * rise)
    half = math.asin(span / 2 / radius)

    def at(k, r):
        angle = half - 2 * half * k / count
        return (size * (span / 2 - r * math.sin(angle)), size * (rise - radius + r * math.cos(angle)))

    for k in range(count):
        corners = [at(k, radius), at(k + 1, radius), at(k + 1, radius + ring), at(k, radius + ring)]
        if faces == "chords":
            closed(space, corners, "RING")
        else:
            # Faces along the circles: the intrados turns right, the extrados left.
            bulge = math.tan(half / count / 2)
            bulges = [-bulge, 0, bulge, 0]
            closed(space, [(x, y, b) for (x, y), b in zip(corners, bulges)], "RING", format="xyb")
    for side, k in ((-1, 0), (1, count)):
        (ax, ay), (bx, by) = at(k, radius), at(k, radius + ring)
        back, low = bx + side * 2.0 * size, ay - 2.0 * size
        closed(space, [(back, low), (ax, low), (ax, ay), (bx, by), (back, by)], "ABUTMENT")
    space.add_text("Bridgemill, case 1", dxfattribs={"layer": "NOTES", "height": 0.3 * size})
    save(doc, name)


def curves():
    doc, space = new(units.M)
    # A block with a round head: 1 m wide, 1 m to the springing of a half circle.
    closed(space, [(0, 0, 0), (1, 0, 0), (1, 1, 1), (0, 1, 0)], "BULGE", format="xyb")
    # The same from loose lines and an arc, in no order and with some of them backwards.
    for a, b in (((4, 0), (4, 1)), ((3, 0), (4, 0)), ((3, 0), (3, 1))):
        space.add_line(a, b, dxfattribs={"layer": "LOOSE"})
    space.add_arc((3.5, 1), 0.5, 0, 180, dxfattribs={"layer": "LOOSE"})
    space.add_circle((7, 0.5), 0.5, dxfattribs={"layer": "ROUND"})
    space.add_ellipse((10, 0.5), (1, 0.5), 0.4, dxfattribs={"layer": "ELLIPSE"})
    # A closed quadratic spline through rational weights: a circle of radius 0.5 about (13, 0.5).
    w = math.sqrt(0.5)
    square = [(13.5, 0.5), (13.5, 1), (13, 1), (12.5, 1), (12.5, 0.5), (12.5, 0), (13, 0), (13.5, 0), (13.5, 0.5)]
    space.add_rational_spline(
        [(x, y, 0) for x, y in square],
        weights=[1, w, 1, w, 1, w, 1, w, 1],
        degree=2,
        knots=[0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4],
        dxfattribs={"layer": "SPLINE"},
    )
    # Seen from below: an extrusion direction of (0, 0, -1) mirrors x.
    closed(space, [(-16, 0), (-15, 0), (-15, 1)], "BELOW").dxf.extrusion = (0, 0, -1)
    # A polyline of the old kind with a bulge.
    space.add_polyline2d(
        [(18, 0, 0), (19, 0, 0), (19, 1, 0.5), (18, 1, 0)], format="xyb", close=True, dxfattribs={"layer": "OLD"}
    )
    save(doc, "curves.dxf")


def repairs():
    doc, space = new(units.M)
    closed(space, [(0, 0), (1, 0), (1, 0), (1, 1), (0, 1), (0, 0)], "DUPLICATE")
    closed(space, [(2, 0), (2.25, 0), (2.5, 0), (3, 0), (3, 1), (2.5, 1), (2, 1)], "COLLINEAR")
    closed(space, [(4, 0), (4, 1), (5, 1), (5, 0)], "CLOCKWISE")
    # Four lines whose ends miss one another by 0.4 mm, and a polyline whose own ends do.
    corners = [(6, 0), (7, 0), (7, 1), (6, 1)]
    for k, (x, y) in enumerate(corners):
        to = corners[(k + 1) % 4]
        space.add_line((x, y), (to[0] + 0.0004 * (to[0] - x), to[1] + 0.0004 * (to[1] - y)), dxfattribs={"layer": "GAPS"})
    space.add_lwpolyline([(8, 0), (9, 0), (9, 1), (8, 1), (8, 0.0003)], dxfattribs={"layer": "ENDS"})
    save(doc, "repairs.dxf")


def refused():
    doc, space = new(units.M)
    space.add_lwpolyline([(0, 0), (1, 0), (1, 1), (0, 1)], dxfattribs={"layer": "UNCLOSED"})
    closed(space, [(2, 0), (3, 1), (3, 0), (2, 1)], "CROSSED")
    closed(space, [(4, 0), (6, 0), (6, 1), (5, 1), (5, 2), (4, 2)], "CONCAVE")
    closed(space, [(7, 0), (8, 0), (9, 0)], "FLAT")
    closed(space, [(10, 0), (11, 0), (11, 1), (10, 1)], "OVER")
    closed(space, [(10.9, 0.5), (12, 0.5), (12, 1.5), (10.9, 1.5)], "OVER")
    for _ in range(2):
        closed(space, [(13, 0), (14, 0), (14, 1), (13, 1)], "TWICE")
    # Two blocks drawn with one line between them: which ends belong together cannot be told.
    for a, b in (((15, 0), (16, 0)), ((16, 0), (17, 0)), ((16, 0), (16, 1))):
        space.add_line(a, b, dxfattribs={"layer": "SHARED"})
    space.add_line((18, 0, 0), (19, 0, 2), dxfattribs={"layer": "SPACE"})
    save(doc, "refused.dxf")


def references():
    doc, space = new(units.MM)
    stone = doc.blocks.new("STONE", base_point=(100, 0))
    stone.add_lwpolyline([(100, 0), (300, 0), (300, 100), (100, 100)], close=True, dxfattribs={"layer": "0"})
    stone.add_circle((200, 50), 20, dxfattribs={"layer": "DOWELS"})
    pair = doc.blocks.new("PAIR")
    pair.add_blockref("STONE", (0, 0), dxfattribs={"layer": "0"})
    pair.add_blockref("STONE", (0, 100), dxfattribs={"layer": "0"})
    # As drawn; turned by 90 degrees and twice the size; mirrored; an array of three by two; a pair inside a reference.
    space.add_blockref("STONE", (0, 0), dxfattribs={"layer": "PLAIN"})
    turned = {"layer": "TURNED", "rotation": 90, "xscale": 2, "yscale": 2}
    space.add_blockref("STONE", (2000, 0), dxfattribs=turned)
    space.add_blockref("STONE", (4000, 0), dxfattribs={"layer": "MIRRORED", "xscale": -1})
    array = {"layer": "ARRAY", "column_count": 3, "row_count": 2, "column_spacing": 250, "row_spacing": 150}
    space.add_blockref("STONE", (6000, 0), dxfattribs=array)
    space.add_blockref("PAIR", (9000, 0), dxfattribs={"layer": "NESTED"})
    # Stretched, the dowel is no circle any more.
    space.add_blockref("STONE", (11000, 0), dxfattribs={"layer": "STRETCHED", "xscale": 3})
    save(doc, "references.dxf")


def unitless():
    doc, space = new(0)
    closed(space, [(0, 0), (1000, 0), (1000, 500), (0, 500)], "BLOCKS")
    save(doc, "unitless.dxf")


def old():
    """Version R12 knows neither light polylines nor units."""
    doc, space = new(0, "R12")
    space.add_polyline2d([(0, 0), (2, 0), (2, 1), (0, 1)], close=True, dxfattribs={"layer": "BLOCKS"})
    space.add_circle((3, 0.5), 0.5, dxfattribs={"layer": "GRAINS"})
    save(doc, "r12.dxf")


def left_out():
    doc, space = new(units.M)
    closed(space, [(0, 0), (1, 0), (1, 1), (0, 1)], "BLOCKS")
    hatch = space.add_hatch(dxfattribs={"layer": "HATCHES"})
    hatch.paths.add_polyline_path([(0, 0), (1, 0), (1, 1)], is_closed=True)
    for k in range(3):
        space.add_text("note", dxfattribs={"layer": "NOTES", "insert": (k, 2)})
    space.add_point((0.5, 0.5), dxfattribs={"layer": "BLOCKS"})
    save(doc, "left-out.dxf")


def heap():
    """Grains on a floor between two walls, in centimetres."""
    doc, space = new(units.CM)
    closed(space, [(-20, -20), (120, -20), (120, 0), (-20, 0)], "FLOOR")
    for row in range(3):
        for k in range(5):
            space.add_circle((10 + 20 * k, 10 + 20 * row), 10, dxfattribs={"layer": "GRAINS"})
    save(doc, "heap.dxf")


arch("bridgemill.dxf", units.MM, 1000, "chords")
arch("bridgemill-arcs.dxf", units.M, 1, "arcs")
curves()
repairs()
refused()
references()
unitless()
old()
left_out()
heap()
