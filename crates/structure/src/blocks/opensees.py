
FIBRES = 200  # in a joint
GROWTH, FIRST, LAST = 1.05, 1e-6, 0.05  # Steps of the pushed block [m]: from one to the next, the first, and how far in all.


def build():
    """Block k has node k; joint j has a node on each of its blocks, and fibres between them."""
    ops.wipe()
    ops.model("basic", "-ndm", 2, "-ndf", 3)
    for k, (_, held, x, y, _) in enumerate(BLOCKS):
        ops.node(k, x, y)
        if held:
            ops.fix(k, 1, 1, 1)
    for j, (first, second, x, y, nx, ny, length, depth, _, _) in enumerate(JOINTS):
        stiffness = MODULUS / max(depth, 1e-3)
        left, right, normal, shear, section = (1000000 * (n + 1) + j for n in range(5))
        for node, block in ((left, first), (right, second)):
            ops.node(node, x, y)
            if BLOCKS[block][1]:
                ops.fix(node, 1, 1, 1)
            else:
                ops.rigidLink("beam", block, node)
        # A joint of one point is as stiff as one of a millimetre.
        ops.uniaxialMaterial("ENT", normal, stiffness * (1.0 if length > 0.0 else 1e-3))
        ops.uniaxialMaterial("Elastic", shear, SHEAR * stiffness * max(length, 1e-3))
        across = (nx, ny, 0.0), (-ny, nx, 0.0)
        if length > 0.0:
            ops.section("Fiber", section)
            ops.patch("rect", normal, FIBRES, 1, -0.5 * length, -0.5, 0.5 * length, 0.5)
            ops.section("Aggregator", section + 1000000, shear, "Vy", "-section", section)
            ops.element("zeroLengthSection", j, left, right, section + 1000000, "-orient", *across[0], *across[1])
        else:
            ops.element("zeroLength", j, left, right, "-mat", normal, shear, "-dir", 1, 2, "-orient", *across[0], *across[1])
    ops.constraints("Transformation")
    ops.numberer("RCM")
    ops.system("BandGeneral")
    ops.test("NormUnbalance", 1e-6, 200)
    ops.algorithm("KrylovNewton")


def put(pattern, loads):
    """Forces on blocks, each with its moment about the centre of mass."""
    ops.timeSeries("Linear", pattern)
    ops.pattern("Plain", pattern, pattern)
    for block, x, y, fx, fy in loads:
        name, held, cx, cy, _ = BLOCKS[block]
        if not held:
            ops.load(block, fx, fy, (x - cx) * fy - (y - cy) * fx)


def own_weight():
    """Every block's weight and what lies on it, in ten steps."""
    put(1, DEAD + [(k, x, y, 0.0, -weight) for k, (_, _, x, y, weight) in enumerate(BLOCKS)])
    ops.integrator("LoadControl", 0.1)
    ops.analysis("Static")
    if ops.analyze(10) != 0:
        raise SystemExit("the blocks do not come to rest under their own weight")
    ops.loadConst("-time", 0.0)


def reactions():
    """Force of each support on what it carries, to the right and upwards, by the joints on it."""
    found = {}
    ops.reactions()
    for j, (first, second, *_) in enumerate(JOINTS):
        for node, block in ((1000000 + j, first), (2000000 + j, second)):
            if BLOCKS[block][1]:
                right, up, _ = ops.nodeReaction(node)
                known = found.setdefault(BLOCKS[block][0], [0.0, 0.0])
                known[0], known[1] = known[0] + right, known[1] + up
    return found


def sliding():
    """The joint that is nearest to sliding: shear over what friction and cohesion carry."""
    worst = (0.0, "")
    for j, (first, second, _, _, _, _, length, _, friction, cohesion) in enumerate(JOINTS):
        forces = ops.eleResponse(j, "force")
        right, up = forces[3], forces[4]
        nx, ny = JOINTS[j][4:6]
        pressed, sheared = abs(right * nx + up * ny), abs(-right * ny + up * nx)
        strength = friction * pressed + cohesion * length
        if strength > 0.0:
            worst = max(worst, (sheared / strength, f"{BLOCKS[first][0]} on {BLOCKS[second][0]}"))
    return worst


def push():
    """The largest multiple of LIVE, with the block pushed down that takes most of it."""
    put(2, LIVE)
    down = {}
    for block, _, _, _, fy in LIVE:
        down[block] = down.get(block, 0.0) - fy
    pushed_block = max(down, key=down.get)
    factor, pushed, step = 0.0, 0.0, FIRST
    while pushed < LAST:
        ops.integrator("DisplacementControl", pushed_block, 2, -step)
        ops.analysis("Static")
        if ops.analyze(1) != 0:
            break
        factor, pushed, step = max(factor, ops.getTime()), pushed + step, GROWTH * step
    return factor


if __name__ == "__main__":
    build()
    own_weight()
    dead = sum(weight for _, held, _, _, weight in BLOCKS if not held) - sum(fy for block, _, _, _, fy in DEAD if not BLOCKS[block][1])
    print(f"dead load                {dead:12.4f} kN/m")
    for name, (right, up) in reactions().items():
        print(f"reaction  {name:<28} right {right:12.4f}  up {up:12.4f} kN/m")
    worst, where = sliding()
    print(f"nearest to sliding       {worst:12.4f} of its strength, {where}")
    if LIVE:
        size = sum((fx * fx + fy * fy) ** 0.5 for _, _, _, fx, fy in LIVE)
        factor = push()
        print(f"load at collapse         {factor * size:12.4f} kN/m, {factor:.4f} times {size:.4f} kN/m, without sliding")
