//! A filled arch by finite elements beside the bounds: elastic stones, joints without tension, soil of Drucker and Prager.

use crate::continuum_arch::layered;
use crate::continuum_tools::{between, ends, rough, soil};
use crate::fem_tools::held;
use crate::limit_models::{Ring, block};
use mechanics::blocks::{BlockModel, Held, Loading, PointForce};
use mechanics::fem::joint::{Contact as FrictionContact, JointLaw, LiftOff, Mortar, Shear};
use mechanics::fem::law::{Cone, DruckerPrager, Elastic, Material, Plane, Solid};
use mechanics::fem::{
    Element, Interface, Kinematics, Mesh, Model, Quad, Quadrature, Section, Settings as Balance, State, Status,
    Support, Target, Workspace, advance, reactions,
};
use mechanics::ids::{BlockId, Id, NodeId, ZoneId};
use mechanics::limit::continuum::{
    Bears, Bounds, Contact, Continuum, Setting, Side, Soil, Wanted, Which, bound_on, collapse_bounds,
};
use mechanics::limit::{Friction, Settings};
use mechanics::plane::{Polygon, Vec2, vec2};
use mechanics::watch::{CancelToken, Unwatched};

/// A ring under soil between plumb, smooth walls at its springings, pressed by a rigid plate that sinks and neither slides nor turns.
struct FilledArch {
    ring: Ring,
    /// Soil above the crown [m].
    cover: f64,
    soil: Soil,
    /// Coefficient of friction of the soil on the ring; soil takes no tension there.
    friction: f64,
    /// The joints of the ring above which the plate ends.
    plate: [usize; 2],
}

impl FilledArch {
    /// Sharp-edged voussoirs that never slide, so that the flow rule of their joints plays no part.
    fn slender(friction: f64) -> FilledArch {
        let half_angle = 0.8f64.asin();
        let ring = Ring {
            intrados: 2.5,
            thickness: 0.15,
            half_angle,
            voussoirs: 12,
            rounding: 0.0,
            density: 2000.0,
            friction: f64::INFINITY,
        };
        FilledArch { ring, cover: 0.4, soil: soil(5e3, 30.0, 18e3), friction, plate: [2, 4] }
    }

    fn top(&self) -> f64 {
        self.ring.extrados() + self.cover
    }

    /// The ends of the plate, from the left.
    fn feet(&self) -> [Vec2; 2] {
        self.plate.map(|joint| vec2(self.ring.at(joint as f64, self.ring.extrados()).x, self.top()))
    }

    /// The ring, and the plate as its last block; a factor of one is 1 N/m on the plate.
    fn blocks(&self) -> (BlockModel, Loading) {
        let [from, to] = self.feet();
        let outline = Polygon::rectangle(from, to.x - from.x, 0.1).unwrap();
        let (mut model, at) = (self.ring.model(), outline.centroid());
        let plate = model.blocks.push(block(outline, 0.0, 0.0, Held { x: true, y: false, rotation: true }));
        let variable = vec![PointForce { block: plate, at, force: vec2(0.0, -1.0) }];
        (model, Loading { variable, ..Loading::default() })
    }

    fn earth(&self) -> Continuum {
        let contact = Contact { friction: self.friction, cohesion: 0.0, tension: 0.0 };
        let mut earth = layered(&self.ring, &[(self.cover, self.soil)], contact);
        let [from, to] = self.feet();
        let outline = &mut earth.regions[0].outline;
        outline.splice(outline.len() - 1..outline.len() - 1, [to, from]);
        let plate = Some(BlockId::new(self.ring.voussoirs + 2));
        earth.sides.push(Side { ends: [to, from], bears: Bears::Body { block: plate, contact: rough(&self.soil) } });
        earth
    }

    fn bounds(&self, wanted: &Wanted) -> Bounds {
        let (model, loading) = self.blocks();
        let earth = self.earth();
        let setting = Setting::new(&model, &loading, &associated(), &earth).unwrap();
        collapse_bounds(&setting, wanted, &CancelToken::default()).unwrap()
    }

    /// The model of finite elements with `fine` elements along each voussoir and twice as many through the soil.
    fn elements(&self, fine: usize) -> (Model, Vec<NodeId>) {
        let mut laid = Laid { arch: self, fine, mesh: Mesh::default(), supports: Vec::new() };
        let zones = ["stone", "fill"].map(|name| laid.mesh.zones.push(name.to_owned()));
        laid.mesh.kinds = vec!["joint".to_owned(), "contact".to_owned()];
        let backs = laid.stones(zones[0]);
        let foot = laid.fill(zones[1], &backs);
        let sections = [self.stone(), self.ground()].into_iter().collect();
        let laws = vec![JointLaw::Mortar(DRY), JointLaw::Contact(FrictionContact { friction: self.friction, ..TOUCH })];
        (Model::new(laid.mesh, sections, laws, &laid.supports, Kinematics::Small).unwrap(), foot)
    }

    fn stone(&self) -> Section {
        let material = Material::Elastic(Elastic { modulus: 10e9, ratio: 0.2 });
        of(material, self.ring.density)
    }

    fn ground(&self) -> Section {
        let (elastic, s) = (Elastic { modulus: 50e6, ratio: 0.2 }, &self.soil);
        let angle = s.friction_angle;
        let cone = DruckerPrager::matching(elastic, Cone::PlaneStrain, s.cohesion, angle, angle);
        of(Material::DruckerPrager(cone), -s.weight.y / 9.81)
    }

    /// Force on the plate [N/m] when it has sunk so far that the force no longer grows.
    fn carried(&self, fine: usize) -> f64 {
        let (model, foot) = self.elements(fine);
        let (mut state, mut work) = (State::new(&model), Workspace::new(&model).unwrap());
        let forces = model.weight(vec2(0.0, -9.81));
        let mut sunk = |depth: f64| {
            let imposed = foot.iter().map(|at| (*at, 1, -depth)).collect();
            let target = Target { forces: forces.clone(), imposed };
            let outcome = advance(&model, &mut state, &mut work, &target, &Balance::default(), &mut Unwatched);
            assert_eq!(outcome.status, Status::Completed, "{fine}, {depth} m: {outcome:?}");
            let pushes = reactions(&model, &mut work, &state);
            -foot.iter().map(|at| pushes[2 * at.index() + 1]).sum::<f64>()
        };
        let [_, half, whole] = [0.0, 0.04, 0.08].map(&mut sunk);
        assert!((whole / half - 1.0).abs() < 1e-3, "{fine}: {half} {whole}");
        whole
    }
}

fn associated() -> Settings {
    Settings { friction: Friction::Associated, ..Settings::default() }
}

fn of(material: Material, density: f64) -> Section {
    Section { solid: Solid { material, plane: Plane::Strain }, element: Element::QM6, density }
}

/// Joints without tension; only what touches carries shear, of any size.
const DRY: Mortar = Mortar {
    normal: 100e9,
    tangential: 40e9,
    lift_off: LiftOff::Stress(0.0),
    compressive_strength: None,
    shear: Shear::Panel { strength: 1e12, when_open: false },
};

/// The contact of soil and stone but for its friction.
const TOUCH: FrictionContact =
    FrictionContact { normal: 10e9, tangential: 4e9, friction: 0.0, cohesion: 0.0, separation: true, rounding: 0.0 };

/// A mesh that is being laid.
struct Laid<'a> {
    arch: &'a FilledArch,
    fine: usize,
    mesh: Mesh,
    supports: Vec<Support>,
}

impl Laid<'_> {
    /// A point of a flat-faced voussoir, by shares of its length and of its thickness.
    fn place(&self, voussoir: usize, along: f64, up: f64) -> Vec2 {
        let ring = &self.arch.ring;
        let radius = ring.intrados + ring.thickness * up;
        let [a, b] = [voussoir, voussoir + 1].map(|joint| ring.at(joint as f64, radius));
        a * (1.0 - along) + b * along
    }

    /// Elements between columns of as many nodes.
    fn quads(&mut self, columns: &[Vec<NodeId>], zone: ZoneId) {
        for pair in columns.windows(2) {
            for j in 1..pair[0].len() {
                let nodes = [pair[0][j - 1], pair[1][j - 1], pair[1][j], pair[0][j]];
                self.mesh.quads.push(Quad { nodes, zone });
            }
        }
    }

    /// A pair of faces; the second lies on the left of the way along them.
    fn meet(&mut self, one: Vec<NodeId>, two: Vec<NodeId>, kind: usize) {
        self.mesh.interfaces.push(Interface { one, two, kind, quadrature: Quadrature::Nodal });
    }

    /// Voussoirs with joints between them and skewbacks that are held; the nodes of their backs.
    fn stones(&mut self, zone: ZoneId) -> Vec<Vec<NodeId>> {
        let (count, fine, through) = (self.arch.ring.voussoirs, self.fine, self.fine.min(4));
        let column = |laid: &mut Self, voussoir, along: f64| -> Vec<NodeId> {
            let places = (0..=through).map(|j| laid.place(voussoir, along, j as f64 / through as f64));
            places.collect::<Vec<_>>().into_iter().map(|at| laid.mesh.nodes.push(at)).collect()
        };
        let skewbacks = [(0, 0.0), (count - 1, 1.0)].map(|(voussoir, along)| column(self, voussoir, along));
        self.supports.extend(skewbacks.iter().flatten().map(|at| held(*at, true, true)));
        let (mut before, mut backs) = (skewbacks[0].clone(), Vec::new());
        for voussoir in 0..count {
            let columns: Vec<_> = (0..=fine).map(|i| column(self, voussoir, i as f64 / fine as f64)).collect();
            self.quads(&columns, zone);
            self.meet(columns[0].clone(), std::mem::replace(&mut before, columns[fine].clone()), 0);
            backs.push(columns.iter().map(|nodes| nodes[through]).collect());
        }
        self.meet(skewbacks[1].clone(), before, 0);
        backs
    }

    /// Soil on the backs of the voussoirs, between walls that hold it level; the nodes under the plate, which are held.
    fn fill(&mut self, zone: ZoneId, backs: &[Vec<NodeId>]) -> Vec<NodeId> {
        let (fine, rows, top) = (self.fine, 2 * self.fine, self.arch.top());
        let mut floor: Vec<NodeId> = backs.iter().flat_map(|back| back[..fine].to_vec()).collect();
        floor.extend(backs.last().map(|back| back[fine]));
        let mut column = |below: &NodeId| -> Vec<NodeId> {
            let foot = self.mesh.nodes[*below];
            let level = |j: usize| foot.y + (top - foot.y) * j as f64 / rows as f64;
            (0..=rows).map(|j| self.mesh.nodes.push(vec2(foot.x, level(j)))).collect()
        };
        let columns: Vec<_> = floor.iter().map(&mut column).collect();
        self.quads(&columns, zone);
        for (k, back) in backs.iter().enumerate() {
            self.meet(back.clone(), columns[k * fine..=(k + 1) * fine].iter().map(|nodes| nodes[0]).collect(), 1);
        }
        self.supports.extend(columns[0].iter().chain(&columns[columns.len() - 1]).map(|at| held(*at, true, false)));
        let [from, to] = self.arch.plate.map(|joint| joint * fine);
        let foot: Vec<NodeId> = columns[from..=to].iter().map(|nodes| nodes[rows]).collect();
        self.supports.extend(foot.iter().map(|at| held(*at, true, true)));
        foot
    }
}

#[test]
fn finite_elements_lie_between_the_bounds_of_a_filled_arch() {
    // Frictionless between soil and stone: flow there is at right angles to strength in both models.
    let arch = FilledArch::slender(0.0);
    let bounds = arch.bounds(&Wanted { ratio: 1.04, elements: 3000, first: 400, ..Wanted::default() });
    let found = [3, 6, 12].map(|fine| arch.carried(fine));
    assert!(bounds.ratio().unwrap() <= 1.04, "{:?}", bounds.rounds);
    between(found, ends(&bounds));
    // The ring takes part: at four joints and more it turns by over half a radian for each metre that the plate sinks.
    let motions = bounds.motions.as_slice();
    let sinks = -motions[motions.len() - 1].0.y;
    let joints = motions[..arch.ring.voussoirs + 2].windows(2);
    let hinges = joints.filter(|beside| (beside[1].1 - beside[0].1).abs() > 0.5 * sinks).count();
    assert!(hinges >= 4, "{hinges} {motions:?}");
}

#[test]
fn friction_that_does_not_dilate_carries_between_a_smooth_ring_and_one_that_dilates() {
    // Drucker (1954): no less than without friction, no more than where sliding dilates by the angle of friction.
    let arch = FilledArch::slender(0.4);
    let bounds = arch.bounds(&Wanted { ratio: 1.04, elements: 3000, first: 400, ..Wanted::default() });
    let [lower, upper] = ends(&bounds);
    let (model, loading) = arch.blocks();
    let earth = FilledArch::slender(0.0).earth();
    let setting = Setting::new(&model, &loading, &associated(), &earth).unwrap();
    let smooth = bound_on(Which::Lower, &setting, &bounds.mesh, &CancelToken::default()).unwrap();
    let [coarse, fine] = [3, 6].map(|fine| arch.carried(fine));
    assert!(smooth < lower && fine > smooth, "{smooth} {lower} {fine}");
    // Errors halve with the elements, as they do without friction.
    let error = coarse - fine;
    assert!(error > 0.0 && fine <= upper + error, "{coarse} {fine} {upper}");
}
