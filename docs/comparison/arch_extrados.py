"""The same collapse and the same sweep with extrados: limit analysis of the same blocks."""

import json
import math
import time

import extrados

VOUSSOIRS = 21
SWEPT = range(3, 18)  # Vertically above these voussoirs lies their own extrados.
RADIUS, SPRINGING = 2.5, math.asin(2.0 / 2.5)  # Of the intrados: span 4 m, rise 1 m.
BRIDGE = """
bridge = { name = "Arch", width = "1 m" }
masonry = { density = "2200 kg/m^3", compressive_strength = "unlimited" }
joint = { friction_angle = "35 deg", cohesion = "0 kPa" }
span = [{ profile = "segmental", span = "4.0 m", rise = "1.0 m", thickness = "0.35 m", voussoirs = 21 }]
load = [{ kind = "knife-edge", force = "1 kN/m", length = "1 mm", position = "1 m" }]
analysis = { method = "limit", friction = "associated", contact_points = "full-ring" }
"""


def centroid(block):
    """Distance [m] of a block's centroid from the left springing."""
    half = SPRINGING / VOUSSOIRS
    middle = (2 * block + 1) * half - SPRINGING
    low, high = RADIUS, RADIUS + 0.35
    mean = 2.0 * (high**3 - low**3) * math.sin(half) / (3.0 * (high**2 - low**2) * half)
    return 2.0 + mean * math.sin(middle)


def timed(task):
    begun = time.process_time()
    found = task()
    return found, time.process_time() - begun


if __name__ == "__main__":
    bridge = extrados.Bridge.parse(BRIDGE)
    collapse = lambda block: bridge.with_(load_1_position=f"{centroid(block)!r} m").collapse().last_stable_load_kn_per_m or math.inf
    load, seconds = timed(lambda: collapse(VOUSSOIRS // 4))
    loads, sweep_seconds = timed(lambda: [collapse(block) for block in SWEPT])
    print(json.dumps({"load_kn_per_m": load, "cpu_seconds": seconds, "sweep_kn_per_m": loads, "sweep_cpu_seconds": sweep_seconds}))
