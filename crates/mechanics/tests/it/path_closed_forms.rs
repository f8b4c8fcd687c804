//! The equilibrium path beside exact solutions and published curves, each computed here: a truss that snaps through,
//! columns without tension, arches in their elastic range, a bed that crushes; and an arch seen from behind.

use super::dem_bridgemill::{bridgemill, program as blocks_program};
use mechanics::blocks::{Block, BlockModel, ContactLaw, Held, LawTable, Loading, PointForce, Stiffness};
use mechanics::contact::ContactLength;
use mechanics::ids::{BlockId, GroupId, Id, Table};
use mechanics::path::{Cause, Outcome, Program, Settings, Status, collapse};
use mechanics::plane::{Polygon, Vec2, vec2};
use mechanics::watch::Unwatched;
use std::f64::consts::{FRAC_PI_2, PI};

const NORMAL: f64 = 1e9;

/// Joints of these stiffnesses that never slide; a pin stands for `pin` [m].
fn law((normal, shear): (f64, f64), pin: f64) -> ContactLaw {
    ContactLaw {
        normal: Stiffness::Given(normal),
        shear: Stiffness::Given(shear),
        friction: 1e3,
        cohesion: 0.0,
        tension: 0.0,
        crushing: f64::INFINITY,
        fixed_length: Some(pin),
        least_length: 1e-3,
    }
}

/// Free blocks and supports of `density`, with the law of joints between free blocks and that of joints at a support.
fn model(outlines: Vec<(Vec<Vec2>, Held)>, density: f64, [between, at_support]: [ContactLaw; 2]) -> BlockModel {
    let mut groups: Table<GroupId, String> = Table::default();
    let [free, fixed] = ["free", "fixed"].map(|name| groups.push(name.to_string()));
    let mut blocks = Table::default();
    for (corners, held) in outlines {
        let group = if held.is_fixed() { fixed } else { free };
        blocks.push(Block { outline: Polygon::new(corners).unwrap(), rounding: 0.0, density, group, held });
    }
    let mut laws = LawTable::uniform(2, between);
    laws.set(free, fixed, at_support);
    BlockModel { blocks, particles: Table::default(), groups, laws, gravity: vec2(0.0, -9.81) }
}

/// Density [kg/m^3] that presses joints together, and does no more.
const NEARLY_WEIGHTLESS: f64 = 1e-6;

fn run(model: &BlockModel, loading: &Loading, program: &Program) -> Outcome {
    let settings = Settings { resolution: 1e-7, ..Settings::new(ContactLength::Distributed) };
    collapse(model, loading, (&settings, program), None, &mut Unwatched).unwrap()
}

fn peak(outcome: &Outcome) -> f64 {
    assert_eq!(outcome.status, Status::LimitPoint);
    outcome.collapse_factor.unwrap()
}

fn within(value: f64, reference: f64, share: f64) {
    assert!((value / reference - 1.0).abs() <= share, "{value} is not within {share} of {reference}");
}

/// A bar from `foot` to `apex`, pointed at both ends.
fn bar(foot: Vec2, apex: Vec2) -> Vec<Vec2> {
    let (middle, wide) = ((foot + apex) * 0.5, (apex - foot).unit().left() * 0.1);
    vec![foot, middle - wide, apex, middle + wide]
}

/// A block that stands across `along` and ends at a point.
fn anvil(at: Vec2, along: Vec2) -> Vec<Vec2> {
    let across = along.left() * 0.1;
    vec![at - along - across, at - across, at + across, at - along + across]
}

/// Two bars on pins, of the length `l` and the slope `s`: each pin is a spring of the stiffness `k` in every direction, so that
/// the thrust `H` shortens half the span by `3 H / 2 k`. A bar turned to the slope `t` carries `P = 2 H tan t` with
/// `H = 2 k (l cos t - l cos s) / 3`, at most `P = 4 k l sin^3 t / 3` where `cos^3 t = cos s` (von Mises 1923).
#[test]
fn a_truss_snaps_through_at_the_load_of_von_mises() {
    for rise in [0.4, 0.1] {
        let (half, pin) = (2.0_f64, 0.3);
        let (foot, apex, far) = (vec2(0.0, 0.0), vec2(half, rise), vec2(2.0 * half, 0.0));
        let axis = (apex - foot).unit();
        // The right bar has a side at the apex.
        let right = vec![apex - vec2(0.0, 0.1), far, apex + vec2(0.0, 0.1)];
        let outlines = vec![
            (anvil(foot, axis), Held::FIXED),
            (bar(foot, apex), Held::FREE),
            (right, Held::FREE),
            (anvil(far, vec2(-axis.x, axis.y)), Held::FIXED),
        ];
        let model = model(outlines, NEARLY_WEIGHTLESS, [law((NORMAL, NORMAL), pin); 2]);
        let force = |block: usize| PointForce { block: BlockId::new(block), at: apex, force: vec2(0.0, -0.5) };
        let loading = Loading { variable: vec![force(1), force(2)], ..Loading::default() };
        let program = Program { increment: 1e3, limit: 1e12, watched: (BlockId(1), apex) };
        let length = half.hypot(rise);
        let turned = (half / length).cbrt().acos();
        let exact = 4.0 / 3.0 * NORMAL * pin * length * turned.sin().powi(3);
        within(peak(&run(&model, &loading, &program)), exact, 1e-7);
    }
}

/// One bar of that truss against a block that slides along a wall: two pins, so that `P = k l sin^3 t / 2`, whichever block of a
/// pin comes first.
#[test]
fn a_bar_snaps_through_against_a_wall() {
    let (foot, apex, pin) = (vec2(0.0, 0.0), vec2(2.0, 0.4), 0.3);
    let mut outlines = vec![
        (anvil(foot, apex.unit()), Held::FIXED),
        (bar(foot, apex), Held::FREE),
        (anvil(apex, vec2(-1.0, 0.0)), Held { x: true, y: false, rotation: true }),
    ];
    for pushed in [2, 0] {
        let model = model(outlines.clone(), NEARLY_WEIGHTLESS, [law((NORMAL, NORMAL), pin); 2]);
        let force = PointForce { block: BlockId(pushed), at: apex, force: vec2(0.0, -1.0) };
        let loading = Loading { variable: vec![force], ..Loading::default() };
        let program = Program { increment: 1e3, limit: 1e12, watched: (BlockId(1), apex) };
        let turned = (apex.x / apex.norm()).cbrt().acos();
        let exact = 0.5 * NORMAL * pin * apex.norm() * turned.sin().powi(3);
        within(peak(&run(&model, &loading, &program)), exact, 1e-7);
        outlines.reverse();
    }
}

/// The same truss of bars that are bedded on faces of the width `b` and stay in contact over all of them: a joint answers a turn
/// with `k b^3 / 12` as well, so that a flat truss of half span `a` carries `2 k b a (s^2 t - t^3) / 3 + k b^3 (s - t) / 2 a`, with
/// the largest value at `t^2 = s^2 / 3 - b^2 / 4 a^2`. What is left is of the order of the slope squared and of the shear.
#[test]
fn a_flat_truss_on_bedded_joints_snaps_through() {
    let half = 2.0;
    for slope in [0.02, 0.01] {
        let (width, apex) = (0.8 * slope, vec2(half, half * slope));
        let (axis, up) = (apex.unit(), vec2(0.0, 0.5 * width));
        let across = axis.left() * (0.5 * width);
        let mirrored = |corners: &[Vec2]| corners.iter().rev().map(|p| vec2(2.0 * half - p.x, p.y)).collect();
        let support = [-across - axis, -across, across, across - axis];
        let left = [-across, apex - up, apex + up, across];
        let outlines = vec![
            (support.to_vec(), Held::FIXED),
            (left.to_vec(), Held::FREE),
            (mirrored(&left), Held::FREE),
            (mirrored(&support), Held::FIXED),
        ];
        let model = model(outlines, NEARLY_WEIGHTLESS, [law((NORMAL, 10.0 * NORMAL), width); 2]);
        let force = |block: usize| PointForce { block: BlockId::new(block), at: apex, force: vec2(0.0, -0.5) };
        let loading = Loading { variable: vec![force(1), force(2)], ..Loading::default() };
        let program = Program { increment: 1.0, limit: 1e12, watched: (BlockId(1), apex) };
        let found = run(&model, &loading, &program);
        let (stiffness, bent) = (NORMAL * width, width / (2.0 * half));
        let turned = (slope * slope / 3.0 - bent * bent).sqrt();
        let thrust = stiffness * half * (slope * slope - turned * turned) / 3.0;
        let exact = 2.0 * thrust * turned + 2.0 * stiffness * half * bent * bent * (slope - turned);
        within(peak(&found), exact, 3.0 * slope * slope);
        assert_eq!(found.path[found.frames[found.peak.unwrap()].step].opened, 0.0);
    }
}

/// A ring of rigid blocks between two angles from the crown, all of whose joints are pressed by the same thrust.
#[derive(Clone, Copy)]
struct Ring {
    count: usize,
    radius: f64,
    thick: f64,
    half: f64,
    /// Normal and shear stiffness of joints [Pa/m]; those of fixed springings are twice as stiff, so that the sums over joints
    /// are integrals by the trapezoidal rule.
    stiffness: (f64, f64),
    hinged: bool,
}

/// Normal force, shear and moment of a joint.
type Section = [f64; 3];

impl Ring {
    fn angle(&self, joint: usize) -> f64 {
        self.half * (2.0 * joint as f64 / self.count as f64 - 1.0)
    }

    fn middle(&self, block: usize) -> f64 {
        0.5 * (self.angle(block) + self.angle(block + 1))
    }

    fn at(&self, angle: f64, off: f64) -> Vec2 {
        vec2(angle.sin(), angle.cos()) * (self.radius + off)
    }

    /// Blocks from left to right, then the supports; the ends of hinged rings are pointed.
    fn model(&self) -> BlockModel {
        let face = |joint: usize| [-0.5, 0.5].map(|side| self.at(self.angle(joint), side * self.thick));
        let tip = |joint: usize| self.at(self.angle(joint), 0.0);
        let block = |k: usize| {
            let ([a, b], [c, d]) = (face(k), face(k + 1));
            match k {
                0 if self.hinged => vec![tip(0), c, d],
                _ if self.hinged && k + 1 == self.count => vec![a, tip(k + 1), b],
                _ => vec![a, c, d, b],
            }
        };
        let support = |joint: usize, away: f64| {
            let ([a, b], outwards) = (face(joint), self.normal(joint) * away);
            let mut corners = vec![a, b, b + outwards, a + outwards];
            if away < 0.0 {
                corners
            } else {
                corners.reverse();
                corners
            }
        };
        let mut outlines: Vec<_> = (0..self.count).map(|k| (block(k), Held::FREE)).collect();
        outlines.push((support(0, -1.0), Held::FIXED));
        outlines.push((support(self.count, 1.0), Held::FIXED));
        let (normal, shear) = self.stiffness;
        let at_support = (2.0 * normal, 2.0 * shear);
        model(outlines, NEARLY_WEIGHTLESS, [law(self.stiffness, self.thick), law(at_support, self.thick)])
    }

    /// Unit normal of a joint towards the right.
    fn normal(&self, joint: usize) -> Vec2 {
        let angle = self.angle(joint);
        vec2(angle.cos(), -angle.sin())
    }

    /// Forces that press all joints alike, in their middles.
    fn pressing(&self, thrust: f64) -> Vec<PointForce> {
        let size = 2.0 * thrust * (self.half / self.count as f64).sin();
        let force = |k: usize| {
            let (at, inwards) = (self.at(self.middle(k), 0.0), self.at(self.middle(k), 0.0).unit() * -size);
            PointForce { block: BlockId::new(k), at, force: inwards }
        };
        (0..self.count).map(force).collect()
    }

    /// Horizontal thrust, and deflection of the crown [m], of 1 N/m on the axis of a block, found along the path: from the state
    /// in which nothing but what presses the joints acts to that of a small load.
    fn found(&self, loaded: usize) -> (f64, f64) {
        const PRESSED: f64 = 1e3;
        const LOAD: f64 = 10.0;
        let (model, crown) = (self.model(), self.count / 2);
        let force =
            PointForce { block: BlockId::new(loaded), at: self.at(self.middle(loaded), 0.0), force: vec2(0.0, -1.0) };
        let loading = Loading { permanent: self.pressing(PRESSED), variable: vec![force], ..Loading::default() };
        let program = Program { increment: LOAD, limit: LOAD, watched: (BlockId::new(crown), self.at(0.0, 0.0)) };
        let outcome = run(&model, &loading, &program);
        assert_eq!(outcome.status, Status::StableToLastLoad);
        assert!(outcome.path.iter().all(|point| point.opened == 0.0 && point.sliding == 0));
        let joint = outcome.interfaces.iter().position(|face| face.first.index() == crown).unwrap();
        let thrust = |frame: usize| outcome.frames[frame].joints[joint].force().x;
        let (first, last) = (&outcome.path[0], outcome.path.last().unwrap());
        ((thrust(outcome.frames.len() - 1) - thrust(0)) / LOAD, (first.displacement.y - last.displacement.y) / LOAD)
    }

    /// The same by the force method on the joints.
    fn exact(&self, loaded: usize) -> (f64, f64) {
        let (normal, shear) = self.stiffness;
        let ends = |j: usize| if j == 0 || j == self.count { 0.5 } else { 1.0 };
        let turn =
            |j: usize| if self.hinged && ends(j) < 1.0 { 0.0 } else { 12.0 * ends(j) / (normal * self.thick.powi(3)) };
        let gives = |j: usize| [ends(j) / (normal * self.thick), ends(j) / (shear * self.thick), turn(j)];
        let joints = || 0..=self.count;
        // Sections that a force on everything to the right of some joints makes.
        let by = |force: Vec2, at: Vec2, from: usize| -> Vec<Section> {
            let section = |j: usize| {
                let n = self.normal(j);
                [force.dot(n), force.dot(n.left()), (at - self.at(self.angle(j), 0.0)).cross(force)]
            };
            joints().map(|j| if j >= from { section(j) } else { [0.0; 3] }).collect()
        };
        let work = |a: &[Section], b: &[Section]| -> f64 {
            joints().map(|j| (0..3).map(|c| a[j][c] * gives(j)[c] * b[j][c]).sum::<f64>()).sum()
        };
        let less = |a: &[Section], b: &[Section], times: f64| -> Vec<Section> {
            joints().map(|j| [0, 1, 2].map(|c| a[j][c] - times * b[j][c])).collect()
        };
        // What the reactions may add, each without work on the others: the thrust at the springings or at the elastic centre.
        let springing = self.at(self.half, 0.0);
        let centre = joints().map(|j| turn(j) * self.angle(j).cos()).sum::<f64>() * self.radius
            / joints().map(turn).sum::<f64>();
        let height = if self.hinged { springing.y } else { centre };
        let mut free = vec![by(vec2(1.0, 0.0), vec2(0.0, height), 0)];
        if !self.hinged {
            free.push(by(vec2(0.0, 1.0), vec2(0.0, height), 0));
            free.push(vec![[0.0, 0.0, 1.0]; self.count + 1]);
        }
        let released = |block: usize| {
            let at = self.at(self.middle(block), 0.0);
            let loads = by(vec2(0.0, -1.0), at, block + 1);
            let share = if self.hinged { 0.5 * (1.0 - at.x / springing.x) } else { 0.0 };
            less(&loads, &by(vec2(0.0, 1.0), self.at(-self.half, 0.0), 0), -share)
        };
        let loads = released(loaded);
        let whole = free.iter().fold(loads, |left, one| less(&left, one, work(&left, one) / work(one, one)));
        let n = self.normal(0);
        (whole[0][0] * n.x + whole[0][1] * n.left().x, work(&whole, &released(self.count / 2)))
    }
}

/// Bridgemill's ring, fixed and on hinges, under a load that moves over it: its thrust and how far its crown sinks. What is left
/// is the share of the pressing thrust in that of a ring that buckles, and rounding.
#[test]
fn rings_answer_a_moving_load_as_the_force_method_says() {
    for hinged in [false, true] {
        let stiffness = (4.84e10, 0.573e10);
        let ring = Ring { count: 61, radius: 16.4686, thick: 0.711, half: 0.60388, stiffness, hinged };
        let (highest, deepest) = ring.exact(30);
        for loaded in (0..61).step_by(6) {
            let ((thrust, sinks), exact) = (ring.found(loaded), ring.exact(loaded));
            assert!((thrust - exact.0).abs() < 1e-5 * highest, "{hinged} {loaded}: {thrust} {exact:?}");
            assert!((sinks - exact.1).abs() < 1e-4 * deepest, "{hinged} {loaded}: {sinks} {exact:?}");
        }
    }
}

/// Semicircles as stiff in shear as along the axis, fixed and on hinges. Castigliano's theorem gives the thrust of a load at the
/// angle `p` from the crown, with `d = t^2 / 12 r^2` for the forces beside the moments: `cos^2 p / (pi (1 + 2 d))` on hinges and
/// `((2 / pi) (cos p + p sin p) - (1 + sin^2 p) / 2) / (pi / 2 - 4 / pi + pi d)` where the springings are fixed. A load at the
/// crown sinks by `r^3 (c + pi d / 4) / E I`, where `c` is what its two parts below say. What is left falls with the square of the
/// number of blocks.
#[test]
fn semicircles_approach_the_influence_lines_of_castigliano() {
    for (hinged, share) in [(true, 0.3), (false, 3.0)] {
        for count in [21, 63, 189] {
            let (radius, thick, normal) = (5.0_f64, 0.5_f64, 1e9 * count as f64);
            let ring = Ring { count, radius, thick, half: FRAC_PI_2, stiffness: (normal, normal), hinged };
            let least = thick * thick / (12.0 * radius * radius);
            let thrust = |p: f64| {
                let fixed = 2.0 / PI * (p.cos() + p * p.sin()) - 0.5 * (1.0 + p.sin().powi(2));
                let hinges = p.cos().powi(2) / (PI * (1.0 + 2.0 * least));
                if hinged { hinges } else { fixed / (FRAC_PI_2 - 4.0 / PI + PI * least) }
            };
            let left = share / (count * count) as f64;
            for loaded in (count / 42..count).step_by(2 * count / 21) {
                let (found, exact) = (ring.found(loaded).0, thrust(ring.middle(loaded)));
                assert!((found - exact).abs() < left + 1e-6, "{hinged} {count} {loaded}: {found} {exact}");
            }
            let hinges = 0.375 * PI - 1.0 - 0.5 * thrust(0.0);
            let fixed = PI / 8.0 - 1.0 / PI - (2.0 / PI - 0.5) * thrust(0.0);
            let bent = if hinged { hinges } else { fixed };
            let bending = normal * thick.powi(3) / 12.0 * PI * radius / count as f64;
            let sinks = radius.powi(3) / bending * (bent + 0.25 * PI * least);
            within(ring.found(count / 2).1, sinks, 8.0 / (count * count) as f64);
        }
    }
}

/// Largest load of a column without tension that is fixed at its foot, as a share of Euler's load of the whole section, for the
/// eccentricity `e` of the load at its head, all lengths in widths of the column. Where the thrust is `u` from the pressed face,
/// a section that has opened (`u < 1/3`) bends by `k / u^2` with `k = 2 P / 9 E`, so that `u'^2 = 2 k (1 / v - 1 / u)` above a foot
/// with `u = v`. From there to `u`, `x = sqrt(v / 2 k) (sqrt(u (u - v)) + v acosh(sqrt(u / v)))`. Above, where nothing is open, the
/// axis is a sine. `v` is sought that makes the load largest (Yokel 1971; Frisch-Fay 1975).
fn without_tension(e: f64) -> f64 {
    // All in units of `1 / sqrt(2 k)` along the column, in which the square of its height is 4 P H^2 / 9 E b^3.
    let opened = |v: f64, u: f64| v.sqrt() * ((u * (u - v)).sqrt() + v * (u / v).sqrt().acosh());
    let height = |v: f64| {
        if e >= 1.0 / 6.0 {
            return opened(v, 0.5 - e);
        }
        // The sine A cos(w x + p) goes on from the eccentricity 1/6 with the slope that is there.
        let (rate, slope) = (27.0_f64.sqrt(), (1.0 / v - 3.0).sqrt());
        let (size, phase) = ((1.0_f64 / 6.0).hypot(slope / rate), (6.0 * slope / rate).atan());
        opened(v, 1.0 / 3.0) + ((e / size).acos() - phase) / rate
    };
    let most = (0.5 - e).min(1.0 / 3.0);
    let largest = (1..20_000).map(|k| height(most * f64::from(k) / 20_000.0)).fold(0.0, f64::max);
    largest * largest * 9.0 / 4.0 * 48.0 / (PI * PI)
}

/// Largest load of a column of `count` blocks of the width 1 m and `slender` m high, as a share of Euler's load. The joint at
/// the foot stands for half a block.
fn share_of_euler(count: usize, slender: f64, eccentricity: f64) -> f64 {
    let height = slender / count as f64;
    let block = |k: usize| {
        let outline = Polygon::rectangle(vec2(-0.5, height * (k as f64 - 1.0)), 1.0, height).unwrap();
        (outline.vertices().to_vec(), if k == 0 { Held::FIXED } else { Held::FREE })
    };
    let (normal, shear) = (NORMAL * count as f64, NORMAL * count as f64);
    let outlines = (0..=count).map(block).collect();
    let model = model(outlines, NEARLY_WEIGHTLESS, [law((normal, shear), 1.0), law((2.0 * normal, 2.0 * shear), 1.0)]);
    let (head, at) = (BlockId::new(count), vec2(eccentricity, slender));
    let force = PointForce { block: head, at, force: vec2(0.0, -1.0) };
    let loading = Loading { variable: vec![force], ..Loading::default() };
    let euler = PI * PI * normal * height / (48.0 * slender * slender);
    let program = Program { increment: 0.01 * euler, limit: 1e12, watched: (head, at) };
    peak(&run(&model, &loading, &program)) / euler
}

/// The curve over the eccentricity: from `e = b / 6` on, `0.957496 (1 - 2 e / b)^3`. Blocks come near to it with the square of
/// their number, and the share is the same for columns of any slenderness but for the square of that.
#[test]
fn columns_without_tension_carry_what_yokel_says() {
    within(without_tension(1.0 / 6.0), 0.957496 * (2.0_f64 / 3.0).powi(3), 1e-6);
    for eccentricity in [0.01, 1.0 / 24.0, 1.0 / 12.0, 1.0 / 8.0, 1.0 / 6.0, 1.0 / 4.0, 1.0 / 3.0, 0.4] {
        for count in [10_u8, 20, 40] {
            let share = share_of_euler(count.into(), 40.0, eccentricity);
            within(share, without_tension(eccentricity), 0.2 / f64::from(count).powi(2));
        }
    }
    for slender in [10.0, 20.0, 80.0] {
        for eccentricity in [1.0 / 12.0, 1.0 / 3.0] {
            let share = share_of_euler(40, slender, eccentricity);
            within(share, without_tension(eccentricity), 1.25e-4 + 0.02 / (slender * slender));
        }
    }
}

/// The block that rocks on a soft joint (`path_known`), on one that crushes: a turn `t` presses it at the strength `f` over the
/// length `p` from the edge and falls to nothing over `d = f / k t`, so that its weight is `f (p + d / 2)`.
#[test]
fn a_block_rocks_on_a_joint_that_crushes() {
    let (width, height, density, strength) = (1.0, 2.0, 2000.0, 0.5e6);
    let crushes = ContactLaw { crushing: strength, ..law((NORMAL, 10.0 * NORMAL), width) };
    let block = |foot: f64, high: f64| Polygon::rectangle(vec2(-0.5 * width, foot), width, high).unwrap();
    let outlines =
        vec![(block(-1.0, 1.0).vertices().to_vec(), Held::FIXED), (block(0.0, height).vertices().to_vec(), Held::FREE)];
    let model = model(outlines, density, [crushes; 2]);
    let (weight, centre) = (width * height * density * 9.81, 0.5 * height);
    let push = |turn: f64| {
        let falls = strength / (NORMAL * turn);
        let at_strength = weight / strength - 0.5 * falls;
        let (pressed, from_edge) = if at_strength < 0.0 {
            let pressed = (2.0 * weight / (NORMAL * turn)).sqrt();
            (pressed, pressed / 3.0)
        } else {
            let moment = 0.5 * at_strength * at_strength + 0.5 * falls * (at_strength + falls / 3.0);
            (at_strength + falls, moment * strength / weight)
        };
        let arm = 0.5 * width * turn.cos() - from_edge - centre * turn.sin();
        weight * arm / (centre * turn.cos() + (0.5 * width - pressed) * turn.sin())
    };
    let largest = (1..20_000).map(|k| push(1e-6 * f64::from(k))).fold(0.0, f64::max);
    let at = vec2(0.0, centre);
    let force = PointForce { block: BlockId(1), at, force: vec2(1.0, 0.0) };
    let loading = Loading { variable: vec![force], ..Loading::default() };
    let program = Program { increment: 0.01 * weight, limit: 1e12, watched: (BlockId(1), at) };
    let found = run(&model, &loading, &program);
    assert!(found.path.last().unwrap().crushed > 0.0);
    // What is left is of the order of the turn squared.
    within(peak(&found), largest, 3e-4);
}

/// A block that is pushed along its joint gives by `F / k b` and slides at its friction, however many states there are on the way.
#[test]
fn a_block_slides_at_its_friction_after_it_has_given() {
    let (width, friction) = (1.0, 0.5);
    let slides = ContactLaw { friction, ..law((NORMAL, NORMAL), width) };
    let block = |foot: f64| Polygon::rectangle(vec2(-0.5 * width, foot), width, 1.0).unwrap().vertices().to_vec();
    let model = model(vec![(block(-1.0), Held::FIXED), (block(0.0), Held::FREE)], 2000.0, [slides; 2]);
    let (weight, at) = (width * 2000.0 * 9.81, vec2(0.0, 0.0));
    let force = PointForce { block: BlockId(1), at, force: vec2(1.0, 0.0) };
    let loading = Loading { variable: vec![force], ..Loading::default() };
    for steps in [1.5, 40.0] {
        let program = Program { increment: friction * weight / steps, limit: 1e12, watched: (BlockId(1), at) };
        let found = run(&model, &loading, &program);
        within(peak(&found), friction * weight, 1e-7);
        assert_eq!(found.cause, Some(Cause::Sliding));
        let holding: Vec<_> = found.path.iter().skip(1).take_while(|point| point.sliding == 0).collect();
        assert!(!holding.is_empty());
        // The block leans by as little as the joint gives.
        holding.iter().for_each(|point| within(point.displacement.x, point.factor / (NORMAL * width), 1e-5));
    }
}

/// The arch with its blocks in the opposite order, and that seen from behind, carries the same: no joint favours the block that
/// comes first. Points that slide depend on the steps, and those on rounding.
#[test]
fn an_arch_numbered_from_the_other_end_carries_the_same() {
    let distributed = Settings { resolution: 1e-8, tolerance: 1e-11, ..Settings::new(ContactLength::Distributed) };
    let points = Settings::new(ContactLength::Fixed);
    for (settings, fill, share) in [(&distributed, false, 1e-9), (&distributed, true, 1e-9), (&points, false, 1e-5)] {
        let (model, loading) = bridgemill(fill, 1.0);
        let blocks = blocks_program(None);
        let program = Program { increment: blocks.increment, limit: 1000.0, watched: blocks.watched };
        let carries = |model: &BlockModel, loading: &Loading, program: &Program| {
            peak(&collapse(model, loading, (settings, program), None, &mut Unwatched).unwrap())
        };
        let one = carries(&model, &loading, &program);
        for mirrored in [false, true] {
            let last = model.blocks.len() - 1;
            let turned = |p: Vec2| if mirrored { vec2(-p.x, p.y) } else { p };
            let other = |id: BlockId| BlockId::new(last - id.index());
            let block = |k: usize| {
                let block = model.blocks[BlockId::new(last - k)].clone();
                let mut corners: Vec<Vec2> = block.outline.vertices().iter().map(|&p| turned(p)).collect();
                if mirrored {
                    corners.reverse();
                }
                Block { outline: Polygon::new(corners).unwrap(), ..block }
            };
            let from_behind = BlockModel { blocks: (0..=last).map(block).collect(), ..model.clone() };
            let mut forces = loading.clone();
            for force in forces.permanent.iter_mut().chain(&mut forces.variable) {
                *force = PointForce { block: other(force.block), at: turned(force.at), force: turned(force.force) };
            }
            let watched = (other(program.watched.0), turned(program.watched.1));
            within(carries(&from_behind, &forces, &Program { watched, ..program.clone() }), one, share);
        }
    }
}
