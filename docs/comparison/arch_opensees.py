"""The same collapse and the same sweep with OpenSees: rigid voussoirs, and joints as fibres that take no tension; the force is pushed down until it
grows no more. Joints do not slide here: a fibre section has no friction.
"""

import json
import math
import time

import openseespy.opensees as ops

GRAVITY, DENSITY = 9.81, 2200.0  # [m/s2, kg/m3]
VOUSSOIRS = 21
SWEPT = range(3, 18)  # Vertically above these voussoirs lies their own extrados.
RADIUS, THICKNESS, SPRINGING = 2.5, 0.35, math.asin(2.0 / 2.5)  # Of the intrados: span 4 m, rise 1 m.
STIFFNESS = 1e9  # Of the fibres [kN/m3]: high, so that the joints open and hardly close.
FIRST, GROWTH, LAST = 1e-6, 1.05, 5e-2  # Steps of the pushed voussoir [m]: the first, from one to the next, and how far it is pushed in all.


def place(angle, radius):
    return radius * math.sin(angle), radius * math.cos(angle)


def build():
    """Voussoir k has node k; joint k, between voussoirs k - 1 and k, has a node on each side."""
    ops.wipe()
    ops.model("basic", "-ndm", 2, "-ndf", 3)
    half = SPRINGING / VOUSSOIRS
    low, high, middle = RADIUS, RADIUS + THICKNESS, RADIUS + 0.5 * THICKNESS
    centroid = 2.0 * (high**3 - low**3) * math.sin(half) / (3.0 * (high**2 - low**2) * half)
    for block in range(VOUSSOIRS):
        ops.node(block, *place((2 * block + 1) * half - SPRINGING, centroid))
    ops.uniaxialMaterial("ENT", 1, STIFFNESS)
    ops.uniaxialMaterial("Elastic", 2, STIFFNESS * THICKNESS)
    ops.section("Fiber", 1)
    ops.patch("rect", 1, 200, 1, -0.5 * THICKNESS, -0.5, 0.5 * THICKNESS, 0.5)
    ops.section("Aggregator", 2, 2, "Vy", "-section", 1)
    for joint in range(VOUSSOIRS + 1):
        angle = 2 * joint * half - SPRINGING
        left, right = 100 + joint, 200 + joint
        ops.node(left, *place(angle, middle))
        ops.node(right, *place(angle, middle))
        for node, block in ((left, joint - 1), (right, joint)):
            if 0 <= block < VOUSSOIRS:
                ops.rigidLink("beam", block, node)
            else:
                ops.fix(node, 1, 1, 1)
        along = (math.cos(angle), -math.sin(angle), 0.0)
        across = (math.sin(angle), math.cos(angle), 0.0)
        ops.element("zeroLengthSection", 300 + joint, left, right, 2, "-orient", *along, *across)
    ops.timeSeries("Linear", 1)
    ops.pattern("Plain", 1, 1)
    weight = 1e-3 * DENSITY * GRAVITY * half * (high**2 - low**2)
    for block in range(VOUSSOIRS):
        ops.load(block, 0.0, -weight, 0.0)
    ops.constraints("Transformation")
    ops.numberer("RCM")
    ops.system("BandGeneral")
    ops.test("NormUnbalance", 1e-6, 100)
    ops.algorithm("KrylovNewton")
    ops.integrator("LoadControl", 0.1)
    ops.analysis("Static")
    if ops.analyze(10) != 0:
        raise RuntimeError("the arch does not come to rest under its own weight")
    ops.loadConst("-time", 0.0)


def collapse_load(block):
    """The largest force [kN per m of width] on this block; infinite where it still grows at the end."""
    build()
    ops.timeSeries("Linear", 2)
    ops.pattern("Plain", 2, 2)
    ops.load(block, 0.0, -1.0, 0.0)
    pushed, step, loads = 0.0, FIRST, [0.0]
    while pushed < LAST:
        ops.integrator("DisplacementControl", block, 2, -step)
        ops.analysis("Static")
        if ops.analyze(1) != 0:
            break
        loads.append(ops.getTime())
        pushed, step = pushed + step, GROWTH * step
    # The load comes to its limit from below; where it grows with the push it has none.
    return math.inf if loads[-1] > 1.2 * loads[-10] else max(loads)


def timed(task):
    begun = time.process_time()
    found = task()
    return found, time.process_time() - begun


if __name__ == "__main__":
    load, seconds = timed(lambda: collapse_load(VOUSSOIRS // 4))
    loads, sweep_seconds = timed(lambda: [collapse_load(block) for block in SWEPT])
    print(json.dumps({"load_kn_per_m": load, "cpu_seconds": seconds, "sweep_kn_per_m": loads, "sweep_cpu_seconds": sweep_seconds}))
