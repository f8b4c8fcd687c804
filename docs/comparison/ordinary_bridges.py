"""Twelve ordinary bridges by another road: rigid voussoirs in their governing cases, as a linear program of joint forces.

Needs numpy and scipy. Run `extrados assess` on every file of docs/verification/ordinary into OUT/NAME, then

    python docs/comparison/ordinary_bridges.py docs/verification/ordinary OUT

Joints have normal force, shear and moment: no tension, Coulomb friction that dilates, crushing by a rectangular stress block. Loads spread over
the length that the rule gives at the depth under the axle, where extrados follows the slope down to the ring: that is what sets the two apart.
Case, position, factor on the axles and width are those that the assessment names.
"""

import json
import math
import re
import sys
import tomllib
from pathlib import Path

import numpy as np
from scipy.optimize import linprog

GRAVITY = 9.81
# Axle loads [N] and distances [m]; length at the surface [m], spread each way per depth; factors on strength and friction.
LOADS = {
    "cs454-bogie-10": ([98_100.0] * 2, [1.8], 0.30, 0.5, 2.0, 1.0),
    "lm71": ([250_000.0] * 4, [1.6] * 3, 0.25, 0.25, 2.5, 1.25),
}
# Load model 71 beside its axles [N/m], and its distance from them [m].
UNIFORM, GAP = 80_000.0, 0.8


def number(text):
    return float(text.split()[0])


def factor(bridge, vehicle):
    """What all loads of the governing case may be multiplied by."""
    span, cover = bridge["span"][0], bridge["cover"]
    s, rise, t = (number(span[key]) for key in ("span", "rise", "thickness"))
    n = span["voussoirs"]
    radius = (s * s / 4 + rise * rise) / (2 * rise)
    centre = np.array([s / 2, rise - radius])
    half = math.asin(s / 2 / radius)
    angles = [math.pi / 2 + half - 2 * half * k / n for k in range(n + 1)]
    at = lambda r, a: centre + r * np.array([math.cos(a), math.sin(a)])
    joints = [(at(radius, a), at(radius + t, a), a) for a in angles]
    fill, surfacing = (number(layer["thickness"]) for layer in cover)
    road = rise + t + fill + surfacing
    extrados = lambda x: centre[1] + math.sqrt(max((radius + t) ** 2 - (x - centre[0]) ** 2, 0.0))
    case = vehicle["case"].replace("\u2212", "-").replace("\u00a0", " ")
    weights = [float(x) for x in re.findall(r"(?:masonry|fill|surfacing) × ([\d.]+)", case)]
    densities = [number(bridge["masonry"]["density"])] + [number(layer["density"]) for layer in cover]
    masonry, of_fill, of_surfacing = (GRAVITY * w * d for w, d in zip(weights, densities))

    dead, live, centres = np.zeros((n, 3)), np.zeros((n, 3)), []
    for k in range(n):
        corners = [joints[k][0], joints[k][1], joints[k + 1][1], joints[k + 1][0]]
        cross = [p[0] * q[1] - q[0] * p[1] for p, q in zip(corners, corners[1:] + corners[:1])]
        middle = sum(corners) / 4
        centres.append(middle)
        dead[k, 1] -= 0.5 * abs(sum(cross)) * masonry
        ends = np.linspace(corners[1][0], corners[2][0], 12)
        for a, b in zip(ends[:-1], ends[1:]):
            x = (a + b) / 2
            force = -(b - a) * ((road - surfacing - extrados(x)) * of_fill + surfacing * of_surfacing)
            dead[k] += [0.0, force, (x - middle[0]) * force]

    def press(begin, end, pressure):
        for k in range(n):
            a, b = max(begin, joints[k][1][0]), min(end, joints[k + 1][1][0])
            if b > a:
                force = -pressure * (b - a)
                live[k] += [0.0, force, ((a + b) / 2 - centres[k][0]) * force]

    loads, distances, length, spread, on_strength, on_friction = LOADS[vehicle["code"]]
    way = -1 if "travelling to the right" in case else 1
    places = [vehicle["position_m"]]
    for distance in distances:
        places.append(places[-1] + way * distance)
    first, last = re.match(r"axles? (\d+)(?: to (\d+))?", case).groups()
    lifted = re.search(r"lift-off ([\d.]+)/([\d.]+)", case)
    shares = [float(x) for x in lifted.groups()] if lifted else [1.0] * len(loads)
    critical = re.search(r"axle (\d+) with ([\d.]+) times", case)
    width, on_load = vehicle["effective_width_m"], vehicle["load_factor"]
    for k in range(int(first) - 1, int(last or first)):
        force = loads[k] * shares[k] * on_load
        if critical and int(critical[1]) == k + 1:
            force *= float(critical[2])
        reach = length / 2 + spread * (road - extrados(places[k]))
        press(places[k] - reach, places[k] + reach, force / width / (2 * reach))
    beside = re.search(r"uniform load from (\S+) to (\S+) m", case)
    if beside:
        begin, end = map(float, beside.groups())
        press(max(begin, max(places) + GAP), end, UNIFORM * on_load / width)
        press(begin, min(end, min(places) - GAP), UNIFORM * on_load / width)

    # Unknowns: normal force, shear and moment of every joint in units of 10 kN, and the factor.
    unit, unknowns = 1e4, 3 * (n + 1) + 1
    balance, rest = np.zeros((3 * n, unknowns)), np.zeros(3 * n)
    for k in range(n):
        for j, sign in ((k, 1.0), (k + 1, -1.0)):
            inner, outer, a = joints[j]
            lever = (inner + outer) / 2 - centres[k]
            for column, way_of in ((0, (math.sin(a), -math.cos(a))), (1, (math.cos(a), math.sin(a)))):
                moment = lever[0] * way_of[1] - lever[1] * way_of[0]
                balance[3 * k : 3 * k + 3, 3 * j + column] += sign * unit * np.array([*way_of, moment])
            balance[3 * k + 2, 3 * j + 2] += sign * unit
        balance[3 * k : 3 * k + 3, -1], rest[3 * k : 3 * k + 3] = live[k], -dead[k]
    strength = number(bridge["masonry"]["compressive_strength"]) * 1e6 / on_strength
    friction = math.tan(math.radians(number(bridge["joint"]["friction_angle"]))) / on_friction
    rows, limits = [], []
    for j in range(n + 1):
        for sign in (1.0, -1.0):
            row = np.zeros(unknowns)
            row[3 * j + 1], row[3 * j] = sign, -friction
            rows.append(row)
            limits.append(0.0)
            # |M| <= N t / 2 - N^2 / (2 f): tangents of the parabola.
            for tangent in np.linspace(0.0, strength * t, 80):
                row = np.zeros(unknowns)
                row[3 * j + 2], row[3 * j] = sign, -(t / 2 - tangent / strength)
                rows.append(row)
                limits.append(tangent**2 / (2 * strength) / unit)
    bounds = [(None, None)] * (unknowns - 1) + [(0, None)]
    objective = np.r_[np.zeros(unknowns - 1), -1.0]
    found = linprog(objective, A_ub=np.array(rows), b_ub=limits, A_eq=balance, b_eq=rest, bounds=bounds, method="highs")
    return found.x[-1] if found.status == 0 else None


def main(folder, results):
    for file in sorted(Path(folder).glob("*.toml")):
        vehicles = json.loads((Path(results) / file.stem / "result.json").read_text())["vehicles"]
        vehicle = next(one for one in vehicles["vehicles"] if one["code"] == vehicles["governing"])
        by_hand = factor(tomllib.loads(file.read_text()), vehicle)
        print(f"{file.stem:<24}{vehicle['adequacy']:>9.3f}{by_hand:>9.3f}{100 * (by_hand / vehicle['adequacy'] - 1):>8.1f} %")


if __name__ == "__main__":
    main(*sys.argv[1:3])
