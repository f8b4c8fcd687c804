"""Collapse of an arch under a force on one voussoir, and that force moved over the arch: COMPAS, rigid-block equilibrium (RBE) of compas_cra.

RBE says how the blocks are in equilibrium, with tension in the joints where there is no other way. It has no load factor: the largest force without
tension is found by halving an interval. A force on a block is more weight of it, through its centroid.
"""

import contextlib
import io
import json
import math
import time

from compas_cra.algorithms import assembly_interfaces_numpy
from compas_cra.equilibrium import rbe_solve
from compas_cra.geometry import Arch

GRAVITY = 9.81  # [m/s2]
DENSITY = 2200.0  # [kg/m3]
FRICTION = math.tan(math.radians(35.0))
VOUSSOIRS = 21
SWEPT = range(3, 18)  # Vertically above these voussoirs lies their own extrados.
TENSION = 1e-4  # Tension above this share of the force on the block means that the force is not carried; at 1e-2 loads are 8 % too high.


def arch():
    built = Arch(height=1.0, span=4.0, thickness=0.35, depth=1.0, num_blocks=VOUSSOIRS, extra_support=True).assembly()
    assembly_interfaces_numpy(built, nmax=7, tmax=1e-6, amin=1e-3)
    return built


def is_carried(assembly, block, force):
    """Whether the arch of this width of 1 m carries a force [kN] on this block without tension."""
    loaded = assembly.node_block(block)
    loaded.attributes["density"] = 1e-3 * DENSITY * GRAVITY + force / loaded.volume()
    with contextlib.redirect_stdout(io.StringIO()):
        try:
            rbe_solve(assembly, mu=FRICTION, density=1e-3 * DENSITY * GRAVITY)
        except ValueError:
            return False
        finally:
            del loaded.attributes["density"]
    interfaces = [one for edge in assembly.graph.edges() for one in assembly.graph.edge_attribute(edge, "interfaces")]
    tension = max((force["c_nn"] for one in interfaces for force in one.forces), default=0.0)
    return tension < TENSION * max(force, 1.0)


def collapse_load(assembly, block, resolution=0.01):
    """The largest force [kN per m of width] on this block, to a share of itself."""
    low, high = 0.0, 10.0
    while high < 1e4 and is_carried(assembly, block, high):
        low, high = high, 2.0 * high
    if high >= 1e4:
        return math.inf
    while high - low > resolution * high:
        middle = 0.5 * (low + high)
        low, high = (middle, high) if is_carried(assembly, block, middle) else (low, middle)
    return low


def timed(task):
    begun = time.process_time()
    found = task()
    return found, time.process_time() - begun


if __name__ == "__main__":
    assembly = arch()
    quarter = VOUSSOIRS // 4
    load, seconds = timed(lambda: collapse_load(assembly, quarter))
    loads, sweep_seconds = timed(lambda: [collapse_load(assembly, block) for block in SWEPT])
    print(json.dumps({"load_kn_per_m": load, "cpu_seconds": seconds, "sweep_kn_per_m": loads, "sweep_cpu_seconds": sweep_seconds}))
