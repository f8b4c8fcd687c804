"""Two moduli of an arch with fill from the deflections that a crossing axle leaves at three sensors: OpenSees for the model, SciPy for the search.

Linear plane strain: joints do not open, the fill does not yield, the axle stands on the fill without rail and sleepers. The records are computed from
known moduli, with noise of 0.005 mm.
"""

import json
import math
import time

import numpy as np
import openseespy.opensees as ops
from scipy.optimize import least_squares

SPAN, RISE, THICKNESS, COVER = 6.0, 1.5, 0.54, 0.48  # [m]
RADIUS = (0.25 * SPAN**2 + RISE**2) / (2.0 * RISE)
SPRINGING = math.asin(0.5 * SPAN / RADIUS)
ALONG, DEEP, HIGH = 40, 3, 4  # Elements along the ring, across it, and of fill above it.
TOP = RADIUS + THICKNESS + COVER
AXLE = 220.0 / 4.87  # [kN per m of width]
POSITIONS = np.linspace(-3.0, 3.0, 25)
TRUTH = (14e6, 120e3)  # Masonry and fill [kPa].
NOISE = 5e-6  # [m]


def node(column, row):
    """Rows from the intrados to the road."""
    return 1 + column * (DEEP + HIGH + 1) + row


def build(masonry, fill):
    ops.wipe()
    ops.model("basic", "-ndm", 2, "-ndf", 2)
    ops.nDMaterial("ElasticIsotropic", 1, masonry, 0.19)
    ops.nDMaterial("ElasticIsotropic", 2, fill, 0.19)
    for column in range(ALONG + 1):
        angle = SPRINGING * (2.0 * column / ALONG - 1.0)
        for row in range(DEEP + HIGH + 1):
            radius = RADIUS + THICKNESS * min(row / DEEP, 1.0)
            x, y = radius * math.sin(angle), radius * math.cos(angle)
            ops.node(node(column, row), x, y + max(row - DEEP, 0) / HIGH * (TOP - y))
            if column in (0, ALONG):
                ops.fix(node(column, row), 1, 1 if row <= DEEP else 0)
    for column in range(ALONG):
        for row in range(DEEP + HIGH):
            corners = node(column, row), node(column + 1, row), node(column + 1, row + 1), node(column, row + 1)
            ops.element("quad", node(column, row), *corners, 1.0, "PlaneStrain", 1 if row < DEEP else 2)
    ops.constraints("Plain")
    ops.numberer("RCM")
    ops.system("BandSPD")
    ops.algorithm("Linear")
    ops.integrator("LoadControl", 1.0)
    ops.analysis("Static")


def records(moduli):
    """Deflections [m]: a row for each position, a column for each sensor."""
    build(*moduli)
    road = np.array([ops.nodeCoord(node(column, DEEP + HIGH), 1) for column in range(ALONG + 1)])
    sensors = [node(column, 0) for column in (ALONG // 4, ALONG // 2, 3 * ALONG // 4)]
    rows = []
    for number, position in enumerate(POSITIONS, start=1):
        column = min(max(int(np.searchsorted(road, position)) - 1, 0), ALONG - 1)
        share = (position - road[column]) / (road[column + 1] - road[column])
        ops.timeSeries("Constant", number)
        ops.pattern("Plain", number, number)
        ops.load(node(column, DEEP + HIGH), 0.0, -AXLE * (1.0 - share))
        ops.load(node(column + 1, DEEP + HIGH), 0.0, -AXLE * share)
        ops.analyze(1)
        rows.append([ops.nodeDisp(sensor, 2) for sensor in sensors])
        ops.remove("loadPattern", number)
    return np.array(rows)


if __name__ == "__main__":
    begun = time.process_time()
    measured = records(TRUTH)
    measured = measured + NOISE * np.random.default_rng(1).standard_normal(measured.shape)
    evaluations = 0

    def residuals(logarithms):
        global evaluations
        evaluations += 1
        return ((records(np.exp(logarithms)) - measured) / NOISE).ravel()

    found = least_squares(residuals, np.log((16e6, 110e3)), diff_step=1e-4)
    moduli = np.exp(found.x)
    # Linearised: the noise is known.
    deviations = moduli * np.sqrt(np.diag(np.linalg.inv(found.jac.T @ found.jac)))
    print(
        json.dumps(
            {
                "masonry_gpa": moduli[0] / 1e6,
                "fill_mpa": moduli[1] / 1e3,
                "deviation_masonry_gpa": deviations[0] / 1e6,
                "deviation_fill_mpa": deviations[1] / 1e3,
                "peak_mm": 1e3 * float(np.abs(measured).max()),
                "evaluations": evaluations,
                "cpu_seconds": time.process_time() - begun,
            }
        )
    )
