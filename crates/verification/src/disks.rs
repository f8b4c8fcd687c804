//! Dense discs in a closed box near rest: the work on which programs for particles are compared.

use mechanics::blocks::{Block, BlockModel, ContactLaw, Held, LawTable, Loading, Particle, Stiffness};
use mechanics::dem::{
    ContactLength, Damping, Grain, Model, PackingError, Recipe, Settings, State, Target, Workspace, begin, frame, pack,
    step,
};
use mechanics::ids::{GroupId, Table};
use mechanics::plane::{Polygon, Vec2, vec2};
use mechanics::watch::{Progress, Watch, Wish};

/// Radii are spread evenly between these [m].
const RADII: (f64, f64) = (0.06, 0.09);

/// Share of the box that the discs cover.
pub const SOLID_FRACTION: f64 = 0.86;

/// Mass density [kg/m^3], stiffnesses per unit area [Pa/m] of contacts that stand for 0.15 m, and angle of friction [deg]: the fill of
/// the Bridgemill arch (Rouxinol, Providência and Lemos, Tables 1 and 2).
const DENSITY: f64 = 1890.0;
const STIFFNESS: (f64, f64) = (0.532e9, 0.222e9);
const CONTACT_LENGTH: f64 = 0.15;
const FRICTION_ANGLE: f64 = 35.6;

/// Most discs that are packed one by one; more are made of mirror images of one packing.
const PACKED: usize = 2_000;

/// Least steps under friction and gravity before a measure, and the most.
const SETTLING: (u64, u64) = (1_000, 20_000);

/// Largest move in a step, as a share of the mean radius, below which the discs count as near rest.
const REST: f64 = 1e-5;

/// A box of discs.
#[derive(Debug, Clone)]
pub struct Disks {
    /// Walls and discs.
    pub model: Model,
    /// How many packings were put side by side.
    pub tiles: usize,
    /// Side of the box [m].
    pub side: f64,
}

/// What the contacts of a box amount to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Touching {
    /// Closed contacts over discs.
    pub contacts_per_particle: f64,
    /// Mean number of contacts of a disc: one between two discs counts for both.
    pub coordination: f64,
}

/// Local damping of 0.7 and 0.8 of the critical step.
pub fn settings() -> Settings {
    Settings {
        damping: Damping::Local(0.7),
        contact_length: ContactLength::Fixed,
        tolerance: 1e-5,
        step_limit: u64::MAX,
        time_step_factor: 0.8,
        scaled_inertia: false,
    }
}

/// Packs `count` discs. A packing under walls and its mirror image fit one another contact by contact, so a large box is made of
/// a smaller one without packing it anew; what it costs to step does not know of the symmetry.
///
/// # Errors
/// Discs that cannot be packed, or a stop by the onlooker.
pub fn disks(count: usize, watch: &mut dyn Watch) -> Result<Disks, PackingError> {
    let tiles = tiles_along(count);
    let in_tile = count.div_ceil(tiles * tiles);
    let side = side(in_tile);
    let grains = packed(in_tile, side, watch)?;
    let whole = tiles as f64 * side;
    let mut model = empty(count, whole)?;
    model.particles = tiled(&grains, tiles, side)
        .take(count)
        .map(|g| Particle { centre: g.centre, radius: g.radius, density: DENSITY, group: GroupId(1) })
        .collect::<Table<_, _>>();
    Ok(Disks { model: Model::new(&model, &Loading::default())?, tiles: tiles * tiles, side: whole })
}

/// How many packings stand along a side: as few as may be, and such that they come out even where that is possible.
fn tiles_along(count: usize) -> usize {
    let least = (1..).find(|k| count.div_ceil(k * k) <= PACKED).unwrap_or(1);
    (least..2 * least).find(|k| count.is_multiple_of(k * k)).unwrap_or(least)
}

/// Side [m] of a square that `count` discs cover as wanted.
fn side(count: usize) -> f64 {
    let (a, b) = RADII;
    let mean_square = (a * a + a * b + b * b) / 3.0;
    (count as f64 * std::f64::consts::PI * mean_square / SOLID_FRACTION).sqrt()
}

fn packed(count: usize, side: f64, watch: &mut dyn Watch) -> Result<Vec<Grain>, PackingError> {
    let region = [vec2(0.0, 0.0), vec2(side, 0.0), vec2(side, side), vec2(0.0, side)];
    let recipe = Recipe {
        count,
        size_ratio: RADII.1 / RADII.0,
        target: Target::SolidFraction(SOLID_FRACTION),
        seed: 1,
        density: DENSITY,
        group: GroupId(1),
    };
    Ok(pack(&empty(count, side)?, &region, &recipe, watch)?.grains)
}

/// The packing in the first tile, its mirror images in the others.
fn tiled(grains: &[Grain], tiles: usize, side: f64) -> impl Iterator<Item = Grain> {
    let image = move |x: f64, tile: usize| tile as f64 * side + if tile.is_multiple_of(2) { x } else { side - x };
    let places = (0..tiles).flat_map(move |row| (0..tiles).map(move |column| (column, row)));
    places.flat_map(move |(column, row)| {
        grains.iter().map(move |g| Grain { centre: vec2(image(g.centre.x, column), image(g.centre.y, row)), ..*g })
    })
}

/// Four walls around a square of `side` [m] for so many discs.
fn empty(count: usize, side: f64) -> Result<BlockModel, PackingError> {
    let law = ContactLaw {
        normal: Stiffness::Given(STIFFNESS.0),
        shear: Stiffness::Given(STIFFNESS.1),
        friction: FRICTION_ANGLE.to_radians().tan(),
        cohesion: 0.0,
        tension: 0.0,
        crushing: f64::INFINITY,
        fixed_length: Some(CONTACT_LENGTH),
        least_length: 0.1 * CONTACT_LENGTH,
    };
    let t = 0.3;
    let wall = |corner: Vec2, width: f64, height: f64| -> Result<Block, PackingError> {
        let outline = Polygon::rectangle(corner, width, height).map_err(|_| PackingError::NoRoom(count))?;
        Ok(Block { outline, rounding: 0.0, density: DENSITY, group: GroupId(0), held: Held::FIXED })
    };
    let blocks = [
        wall(vec2(-t, -t), side + 2.0 * t, t)?,
        wall(vec2(-t, 0.0), t, side)?,
        wall(vec2(side, 0.0), t, side)?,
        wall(vec2(-t, side), side + 2.0 * t, t)?,
    ];
    Ok(BlockModel {
        blocks: blocks.into_iter().collect(),
        particles: Table::default(),
        groups: ["wall".to_owned(), "discs".to_owned()].into_iter().collect(),
        laws: LawTable::uniform(2, law),
        gravity: vec2(0.0, -9.81),
    })
}

impl Disks {
    /// Friction, gravity and damping act until the discs are near rest. `None` if the onlooker stopped it.
    pub fn settled(&self, watch: &mut dyn Watch) -> Option<(State, Workspace)> {
        const LOOK: u64 = 100;
        let (settings, mut work) = (settings(), Workspace::default());
        let mut state = begin(&self.model, &settings);
        while state.steps < SETTLING.1 {
            let mut moved = 0.0_f64;
            for _ in 0..LOOK {
                moved = moved.max(step(&self.model, &mut state, &mut work, &settings).particles_moved);
            }
            let stage = format!("settling, {:.0e} of a radius a step", moved / mean_radius());
            let fraction = Some(state.steps as f64 / SETTLING.0 as f64).filter(|share| *share <= 1.0);
            if watch.look(&Progress { stage, fraction, steps: state.steps }) == Wish::Stop {
                return None;
            }
            if state.steps >= SETTLING.0 && moved <= REST * mean_radius() {
                break;
            }
        }
        Some((state, work))
    }

    /// Contacts that are closed.
    pub fn touching(&self, state: &State) -> Touching {
        let frame = frame(&self.model, state);
        let count = frame.particles.len() as f64;
        let pairs = frame.particle_contacts.iter();
        let ends: usize =
            pairs.map(|c| if matches!(c.partner, mechanics::dem::Body::Particle(_)) { 2 } else { 1 }).sum();
        Touching {
            contacts_per_particle: frame.particle_contacts.len() as f64 / count,
            coordination: ends as f64 / count,
        }
    }
}

/// Mean radius of the discs [m].
pub fn mean_radius() -> f64 {
    0.5 * (RADII.0 + RADII.1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use mechanics::watch::Unwatched;

    /// Counts that come out even are made of equal tiles; none is packed that is larger than need be.
    #[test]
    fn tiles_come_out_even_where_they_can() {
        assert_eq!([2_000, 20_000, 200_000].map(tiles_along), [1, 4, 10]);
        assert_eq!(tiles_along(5_001), 2);
    }

    /// The mirror images are in balance as the packing was: near rest, as dense as asked for, at least four contacts a disc.
    #[test]
    fn a_tiled_box_is_dense_and_near_rest() {
        let disks = disks(6_000, &mut Unwatched).unwrap();
        assert_eq!(disks.tiles, 4, "{}", disks.side);
        let (state, _) = disks.settled(&mut Unwatched).unwrap();
        let touching = disks.touching(&state);
        assert!(touching.coordination >= 4.0, "{touching:?}");
        let covered: f64 =
            state.particles(&disks.model).iter().map(|p| std::f64::consts::PI * p.radius * p.radius).sum();
        assert!((covered / disks.side.powi(2) - SOLID_FRACTION).abs() < 1e-9, "{covered}");
        assert!(state.steps < SETTLING.1, "{} steps", state.steps);
    }
}
