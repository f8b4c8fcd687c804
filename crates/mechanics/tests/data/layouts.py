"""Upper bounds by discontinuity layout optimisation, after Smith and Gilbert (2007): soil is cut along straight lines between the nodes of a grid
and its pieces slide without turning; voussoirs are rigid blocks that turn at their corners. docs/verification/continuum.md holds the results
beside the bounds of this crate, with which this program shares nothing. Needs numpy and scipy.

    python layouts.py trapdoor DEPTH WIDTH NODES_A_METRE [LONGEST_LINE]
    python layouts.py arch DIVISIONS_A_VOUSSOIR ROWS LONGEST_LINE [FRICTION_ON_THE_RING]
"""

import sys
from math import gcd

import numpy as np
from scipy.optimize import linprog
from scipy.sparse import coo_matrix


class Program:
    """A linear program: least cost of variables that are free or not negative, under equations."""

    def __init__(self):
        self.cost, self.free, self.rhs = [], [], []
        self.rows, self.cols, self.vals = [], [], []

    def var(self, cost, free=False):
        self.cost.append(cost)
        self.free.append(free)
        return len(self.cost) - 1

    def eq(self, right=0.0):
        self.rhs.append(right)
        return len(self.rhs) - 1

    def add(self, row, var, value):
        if value:
            self.rows.append(row)
            self.cols.append(var)
            self.vals.append(value)

    def at_least_zero(self, terms):
        row = self.eq()
        for var, value in terms:
            self.add(row, var, value)
        self.add(row, self.var(0.0), -1.0)

    def solve(self):
        matrix = coo_matrix((self.vals, (self.rows, self.cols)), shape=(len(self.rhs), len(self.cost))).tocsr()
        bounds = [(None if free else 0, None) for free in self.free]
        found = linprog(self.cost, A_eq=matrix, b_eq=self.rhs, bounds=bounds, method="highs-ipm")
        return found.fun if found.status == 0 else None


def trapdoor(depth, width, per_metre, longest):
    """Largest pressure on clay with a cohesion of 1 over half of an opening 1 m wide; a half of the body, cut at its middle."""
    nx, ny = round(width * per_metre), round(depth * per_metre)
    places = np.array([(i / per_metre, j / per_metre) for j in range(ny + 1) for i in range(nx + 1)])
    program, lines = Program(), 0
    nodes = [(program.eq(), program.eq()) for _ in places]
    work = program.eq(1.0)
    for j in range(ny + 1):
        for i in range(nx + 1):
            for dj in range(ny + 1 - j):
                for di in range(-i, nx + 1 - i):
                    if (dj == 0 and di <= 0) or gcd(abs(di), dj) != 1 or np.hypot(di, dj) > longest * per_metre:
                        continue
                    a, b = j * (nx + 1) + i, (j + dj) * (nx + 1) + i + di
                    lines += 1
                    (x0, y0), (x1, y1) = places[a], places[b]
                    length = np.hypot(x1 - x0, y1 - y0)
                    along = np.array([x1 - x0, y1 - y0]) / length
                    across = np.array([-along[1], along[0]])
                    near = lambda u, v: abs(u - v) < 1e-9
                    top, low = near(y0, depth) and near(y1, depth), near(y0, 0) and near(y1, 0)
                    edge = near(x0, x1) and (near(x0, 0) or near(x0, width))
                    hole, base = low and max(x0, x1) <= 0.5 + 1e-9, low and min(x0, x1) >= 0.5 - 1e-9
                    if low and not hole and not base:
                        continue
                    if top or hole:
                        jumps = [(1, 0, 0.0), (-1, 0, 0.0), (0, 1, 0.0), (0, -1, 0.0)]
                    else:
                        jumps = [(1, 0, 0.0 if edge else 1.0), (-1, 0, 0.0 if edge else 1.0)]
                    for slip, opening, cohesion in jumps:
                        var = program.var(cohesion * length)
                        jump = slip * along + opening * across
                        for node, sign in ((a, 1), (b, -1)):
                            program.add(nodes[node][0], var, sign * jump[0])
                            program.add(nodes[node][1], var, sign * jump[1])
                        if top:
                            program.add(work, var, jump[1] * length)
    return program.solve(), lines


INTRADOS, EXTRADOS, VOUSSOIRS, HALF_ANGLE = 2.5, 2.65, 12, np.arcsin(0.8)
TOP, PLATE = EXTRADOS + 0.4, (2, 4)
COHESION, FRICTION, SOIL_WEIGHT, STONE_WEIGHT = 5e3, np.tan(np.radians(30)), 18e3, 2000 * 9.81


def on_ring(joint, radius):
    angle = -HALF_ANGLE + 2 * HALF_ANGLE * joint / VOUSSOIRS
    return np.array([radius * np.sin(angle), radius * np.cos(angle)])


def area_above(a, b):
    """Between a line and the upper face."""
    return 0.5 * abs(b[0] - a[0]) * (2 * TOP - a[1] - b[1])


def centroid(corners):
    x, y = corners[:, 0], corners[:, 1]
    cross = x * np.roll(y, -1) - np.roll(x, -1) * y
    middle = [((x + np.roll(x, -1)) * cross).sum(), ((y + np.roll(y, -1)) * cross).sum()]
    return np.array(middle) / (3 * cross.sum()), 0.5 * abs(cross.sum())


def ring(program):
    """Voussoirs with joints that open about their corners and never slide; gives the velocity of their points in a direction."""
    unknowns = [[program.var(0.0, True) for _ in range(3)] for _ in range(VOUSSOIRS)]
    middles = []
    for k in range(VOUSSOIRS):
        corners = [on_ring(k, INTRADOS), on_ring(k, EXTRADOS), on_ring(k + 1, EXTRADOS), on_ring(k + 1, INTRADOS)]
        middle, area = centroid(np.array(corners))
        middles.append(middle)
        program.cost[unknowns[k][1]] += STONE_WEIGHT * area

    def velocity(k, at, direction, sign=1.0):
        if not 0 <= k < VOUSSOIRS:
            return []
        arm = at - middles[k]
        shares = (direction[0], direction[1], arm[0] * direction[1] - arm[1] * direction[0])
        return [(var, sign * share) for var, share in zip(unknowns[k], shares)]

    for joint in range(VOUSSOIRS + 1):
        up = on_ring(joint, 1.0)
        apart = np.array([up[1], -up[0]])
        inner, outer = on_ring(joint, INTRADOS), on_ring(joint, EXTRADOS)
        for corner in (inner, outer):
            program.at_least_zero(velocity(joint, corner, apart) + velocity(joint - 1, corner, apart, -1.0))
        row = program.eq()
        for var, share in velocity(joint, outer, up) + velocity(joint - 1, outer, up, -1.0):
            program.add(row, var, share)
    return velocity


def may_slip(a, b, floor, places):
    """Whether a line between two nodes runs through soil and through no other node."""
    if min(abs(a[1] - TOP), abs(b[1] - TOP)) < 1e-9 and abs(a[1] - b[1]) < 1e-9:
        return False
    left, right = sorted((a[0], b[0]))
    if right - left < 1e-9 and min(abs(left - floor[0][0]), abs(left - floor[-1][0])) < 1e-9:
        return False
    if right - left > 1e-9:
        inner = floor[(floor[:, 0] > left + 1e-9) & (floor[:, 0] < right - 1e-9)]
        level = a[1] + (b[1] - a[1]) * (inner[:, 0] - a[0]) / (b[0] - a[0])
        ground = np.interp(0.5 * (left + right), floor[:, 0], floor[:, 1])
        if np.any(level < inner[:, 1] - 1e-9) or abs(0.5 * (a[1] + b[1]) - ground) < 1e-9:
            return False
    run = b - a
    length = np.hypot(*run)
    arms = places - a
    aside = np.abs(arms[:, 0] * run[1] - arms[:, 1] * run[0]) / length
    along = (arms @ run) / length
    return not np.any((aside < 1e-7) & (along > 1e-7) & (along < length - 1e-7))


def arch(divisions, rows, longest, friction):
    """Force [kN/m] on a plate over two voussoirs of the filled arch of `continuum_elements.rs`, which sinks and neither slides nor turns."""
    program = Program()
    velocity = ring(program)
    backs = [on_ring(k, EXTRADOS) for k in range(VOUSSOIRS + 1)]
    floor = [a + (b - a) * k / divisions for a, b in zip(backs, backs[1:]) for k in range(divisions)]
    floor = np.array(floor + [backs[-1]])
    columns = len(floor)
    places = np.array([(x, y + (TOP - y) * k / rows) for x, y in floor for k in range(rows + 1)])
    node = lambda column, row: column * (rows + 1) + row
    closed = [(program.eq(), program.eq()) for _ in places]
    # The boundary, counter-clockwise.
    walk = [("ring", node(i, 0), node(i + 1, 0), i // divisions) for i in range(columns - 1)]
    walk += [("wall", node(columns - 1, k), node(columns - 1, k + 1), 0) for k in range(rows)]
    feet = [backs[k][0] for k in PLATE]
    for i in range(columns - 1, 0, -1):
        under = feet[0] < 0.5 * (floor[i][0] + floor[i - 1][0]) < feet[1]
        walk.append(("plate" if under else "free", node(i, rows), node(i - 1, rows), 0))
    walk += [("wall", node(0, k), node(0, k - 1), 0) for k in range(rows, 0, -1)]
    beside = []
    for kind, a, b, voussoir in walk:
        u = [program.var(0.0, True), program.var(0.0, True)]
        beside.append(u)
        run = places[b] - places[a]
        length = np.hypot(*run)
        along = run / length
        inwards = np.array([-along[1], along[0]])
        if kind == "ring":
            program.cost[u[1]] += SOIL_WEIGHT * area_above(places[a], places[b])
            for end in (places[a], places[b]):
                for way in [inwards + sign * friction * along for sign in ((1, -1) if friction else (0,))]:
                    program.at_least_zero([(u[0], way[0]), (u[1], way[1])] + velocity(voussoir, end, way, -1.0))
        elif kind == "wall":
            program.add(program.eq(), u[0], 1.0)
        elif kind == "plate":
            sinks = [program.eq(0.0), program.eq(-1.0)]
            for sign in (1, -1):
                jump, var = sign * along + FRICTION * inwards, program.var(COHESION * length)
                for axis in (0, 1):
                    program.add(sinks[axis], var, -jump[axis])
            for axis in (0, 1):
                program.add(sinks[axis], u[axis], 1.0)
    for k, (_, _, b, _) in enumerate(walk):
        for axis in (0, 1):
            program.add(closed[b][axis], beside[k][axis], -1.0)
            program.add(closed[b][axis], beside[(k + 1) % len(walk)][axis], 1.0)
    taken, lines = {tuple(sorted((a, b))) for _, a, b, _ in walk}, 0
    for a in range(len(places)):
        for b in range(a + 1, len(places)):
            run = places[b] - places[a]
            length = np.hypot(*run)
            if length > longest or (a, b) in taken or not may_slip(places[a], places[b], floor, places):
                continue
            lines += 1
            along = run / length
            across = np.array([-along[1], along[0]])
            upper = np.sign(across[1]) if abs(across[1]) > 1e-9 else 0.0
            for sign in (1, -1):
                jump = sign * along + FRICTION * across
                weight = SOIL_WEIGHT * area_above(places[a], places[b]) * upper * jump[1]
                var = program.var(COHESION * length + weight)
                for end, way in ((a, 1), (b, -1)):
                    for axis in (0, 1):
                        program.add(closed[end][axis], var, way * jump[axis])
    return program.solve() / 1e3, len(places), lines


if __name__ == "__main__":
    what, *rest = sys.argv[1:]
    numbers = [float(x) for x in rest]
    if what == "trapdoor":
        print(trapdoor(numbers[0], numbers[1], int(numbers[2]), (numbers + [9.0])[3]))
    else:
        print(arch(int(numbers[0]), int(numbers[1]), numbers[2], (numbers + [0.0])[3]))
