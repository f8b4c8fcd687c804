//! Fills a region with particles by radius expansion: small particles are strewn at random and grow until they carry one
//! another (Itasca 2002, as in Rouxinol, Providência and Lemos). Without friction while they grow, so that they find the
//! densest order that chance allows; friction comes with the analysis.

use super::model::Model;
use super::particles::Disc;
use super::settings::{Damping, Settings};
use super::state::State;
use super::step::{Workspace, begin, step};
use crate::blocks::{BlockModel, Held, Loading, ModelError, Particle};
use crate::contact::ContactLength;
use crate::ids::{GroupId, Table};
use crate::plane::{self, Vec2, bounds, holds, vec2};
use crate::watch::{Progress, Watch, Wish};
use serde::{Deserialize, Serialize};
use thiserror::Error;

/// When the particles have grown enough.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Target {
    /// When they cover this share of the region.
    SolidFraction(f64),
    /// When they press on one another with this mean stress [Pa]: dense, and yet at ease.
    Stress(f64),
}

/// What to fill a region with.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Recipe {
    /// How many particles.
    pub count: usize,
    /// Largest over smallest radius; radii are spread evenly between.
    pub size_ratio: f64,
    /// When to stop.
    pub target: Target,
    /// Seed of places and sizes: the same seed gives the same packing.
    pub seed: u64,
    /// Mass density [kg/m^3].
    pub density: f64,
    /// Group that decides the stiffness of the contacts.
    pub group: GroupId,
}

/// One particle of a packing.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Grain {
    /// Centre [m].
    pub centre: Vec2,
    /// Radius [m].
    pub radius: f64,
}

/// What a packing amounts to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Packed {
    /// Share of the region covered by particles.
    pub solid_fraction: f64,
    /// Mean number of contacts of a particle, with blocks and particles.
    pub coordination: f64,
    /// Mean stress [Pa], compression positive.
    pub mean_stress: f64,
    /// Share of the particles that touch nothing or one thing only.
    pub rattlers: f64,
}

/// Particles that fill a region.
#[derive(Debug, Clone, PartialEq)]
pub struct Packing {
    /// The particles, in the order in which they were strewn.
    pub grains: Vec<Grain>,
    /// What they amount to under the walls and the lid, before friction and gravity.
    pub packed: Packed,
    /// Steps taken.
    pub steps: u64,
}

/// Why a region cannot be filled.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum PackingError {
    /// A number of the recipe makes no sense.
    #[error("the packing's {what} cannot be {value}")]
    Recipe {
        /// Which number.
        what: &'static str,
        /// Its value.
        value: f64,
    },
    /// The region is no area, or too small to strew the particles.
    #[error("the region to be filled has no room for {0} particles")]
    NoRoom(usize),
    /// The walls make no model.
    #[error(transparent)]
    Model(#[from] ModelError),
    /// The onlooker stopped it.
    #[error("the packing was stopped")]
    Stopped,
    /// The particles never pressed on one another as wanted.
    #[error("the particles grew to a solid fraction of {fraction:.3} without reaching the wanted {what}")]
    NotReached {
        /// What was wanted.
        what: &'static str,
        /// How far they grew.
        fraction: f64,
    },
}

/// Radius of a strewn particle as a share of the radius it would have at a solid fraction of one.
const STREWN: f64 = 0.5;

/// Growth of the radii in one stage while the particles are far apart, and its steps.
const LOOSE: (f64, u64) = (0.01, 60);

/// Solid fraction at which growth slows down; a loose random packing of discs carries load from about 0.78.
const SLOW: f64 = 0.77;

/// Growth in one stage near contact, and the most steps that it may take to settle.
const CLOSE: (f64, u64) = (0.002, 1_000);

/// Out-of-balance force over contact force at which a stage has settled.
const SETTLED: f64 = 5e-3;

/// The wanted stress is met within this share.
const MET: f64 = 0.05;

/// Fills `region` (a simple polygon [m], the space between the walls) with particles. All blocks of `walls` are held;
/// `walls` has no particles of its own; friction, cohesion and gravity are left out.
///
/// # Errors
/// A recipe that cannot be, a region without room, walls that are no model, a stop, or particles that never press as wanted.
pub fn pack(
    walls: &BlockModel,
    region: &[Vec2],
    recipe: &Recipe,
    watch: &mut dyn Watch,
) -> Result<Packing, PackingError> {
    check(recipe)?;
    let area = plane::area(region).abs();
    let full = full_radii(recipe, area)?;
    let places = strew(region, &full, recipe)?;
    let model = Model::new(&strewn(walls, &places, &full, recipe), &Loading::default())?;
    let settings = Settings {
        damping: Damping::Local(0.7),
        contact_length: ContactLength::Fixed,
        tolerance: 0.0,
        step_limit: u64::MAX,
        time_step_factor: 0.9,
        scaled_inertia: false,
    };
    let mut growth = Growth {
        state: begin(&model, &settings),
        model: &model,
        settings,
        work: Workspace::default(),
        area,
        share: STREWN,
    };
    growth.swell(recipe.target, watch)?;
    Ok(growth.finish())
}

fn check(recipe: &Recipe) -> Result<(), PackingError> {
    let refuse = |what, value: f64, fine: bool| if fine { Ok(()) } else { Err(PackingError::Recipe { what, value }) };
    refuse("number of particles", recipe.count as f64, recipe.count >= 3)?;
    refuse("size ratio", recipe.size_ratio, (1.0..=100.0).contains(&recipe.size_ratio))?;
    refuse("density", recipe.density, recipe.density > 0.0 && recipe.density.is_finite())?;
    match recipe.target {
        Target::SolidFraction(share) => refuse("solid fraction", share, share > 0.3 && share < 0.95),
        Target::Stress(stress) => refuse("stress", stress, stress > 0.0 && stress.is_finite()),
    }
}

/// Radii [m] that would cover the whole region, in the order of the particles.
fn full_radii(recipe: &Recipe, area: f64) -> Result<Vec<f64>, PackingError> {
    if !(area > 0.0 && area.is_finite()) {
        return Err(PackingError::NoRoom(recipe.count));
    }
    let mut chance = Chance(recipe.seed ^ 0x5EED_0F5A_7E57_0001);
    let sizes: Vec<f64> = (0..recipe.count).map(|_| 1.0 + (recipe.size_ratio - 1.0) * chance.unit()).collect();
    let sum: f64 = sizes.iter().map(|s| std::f64::consts::PI * s * s).sum();
    let scale = (area / sum).sqrt();
    Ok(sizes.into_iter().map(|s| s * scale).collect())
}

/// Places [m] for particles of half their radii that do not overlap.
fn strew(region: &[Vec2], full: &[f64], recipe: &Recipe) -> Result<Vec<Vec2>, PackingError> {
    let (low, high) = bounds(region);
    let mut chance = Chance(recipe.seed ^ 0x5EED_0F5A_7E57_0002);
    let largest = full.iter().copied().fold(0.0, f64::max);
    let side = 2.0 * STREWN * largest;
    let columns = ((high.x - low.x) / side) as usize + 1;
    let rows = ((high.y - low.y) / side) as usize + 1;
    let mut cells: Vec<Vec<u32>> = vec![Vec::new(); columns * rows];
    // The largest first: the small ones find room between.
    let mut order: Vec<usize> = (0..full.len()).collect();
    order.sort_by(|&i, &j| full[j].total_cmp(&full[i]).then(i.cmp(&j)));
    let mut places = vec![Vec2::ZERO; full.len()];
    for i in order {
        let mut tries = 0;
        places[i] = loop {
            tries += 1;
            if tries > 100_000 {
                return Err(PackingError::NoRoom(full.len()));
            }
            let p = vec2(low.x + (high.x - low.x) * chance.unit(), low.y + (high.y - low.y) * chance.unit());
            if !holds(region, p) {
                continue;
            }
            let (cx, cy) = (((p.x - low.x) / side) as usize, ((p.y - low.y) / side) as usize);
            let near = (cy.saturating_sub(1)..(cy + 2).min(rows)).flat_map(|row| {
                (cx.saturating_sub(1)..(cx + 2).min(columns)).map(move |column| row * columns + column)
            });
            let free = near.flat_map(|cell| &cells[cell]).all(|&k| {
                let sum = STREWN * (full[i] + full[k as usize]);
                let apart = places[k as usize] - p;
                apart.dot(apart) >= sum * sum
            });
            if free {
                cells[cy.min(rows - 1) * columns + cx.min(columns - 1)].push(i as u32);
                break p;
            }
        };
    }
    Ok(places)
}

/// The walls with the strewn particles, all held, slippery and weightless.
fn strewn(walls: &BlockModel, places: &[Vec2], full: &[f64], recipe: &Recipe) -> BlockModel {
    let mut model = walls.clone();
    model.blocks.iter_mut().for_each(|b| b.held = Held::FIXED);
    model.laws.iter_mut().for_each(|law| (law.friction, law.cohesion) = (0.0, 0.0));
    model.gravity = Vec2::ZERO;
    let particle = |(&centre, &radius): (&Vec2, &f64)| Particle {
        centre,
        radius: STREWN * radius,
        density: recipe.density,
        group: recipe.group,
    };
    model.particles = places.iter().zip(full).map(particle).collect::<Table<_, _>>();
    model
}

/// Particles on their way to their full size.
struct Growth<'a> {
    model: &'a Model,
    state: State,
    settings: Settings,
    work: Workspace,
    /// Area of the region [m^2].
    area: f64,
    /// Radius now as a share of that at a solid fraction of one.
    share: f64,
}

impl Growth<'_> {
    fn fraction(&self) -> f64 {
        self.share * self.share
    }

    /// Grows the particles until the target is met.
    fn swell(&mut self, target: Target, watch: &mut dyn Watch) -> Result<(), PackingError> {
        let goal = match target {
            Target::SolidFraction(fraction) => fraction,
            Target::Stress(_) => 0.95,
        };
        while self.fraction() < SLOW.min(goal) * (1.0 - 1e-12) {
            let most = (SLOW.min(goal) / self.fraction()).sqrt();
            self.grow((1.0 + LOOSE.0).min(most));
            self.run(LOOSE.1);
            self.tell(target, watch)?;
        }
        match target {
            Target::SolidFraction(fraction) => {
                while self.fraction() < fraction * (1.0 - 1e-12) {
                    let most = (fraction / self.fraction()).sqrt();
                    self.grow((1.0 + CLOSE.0).min(most));
                    self.settle(CLOSE.1);
                    self.tell(target, watch)?;
                }
                self.settle(20 * CLOSE.1);
                Ok(())
            }
            Target::Stress(stress) => self.press(stress, watch),
        }
    }

    /// Grows and shrinks the particles until they press with `wanted` [Pa].
    fn press(&mut self, wanted: f64, watch: &mut dyn Watch) -> Result<(), PackingError> {
        let mut step = CLOSE.0;
        let mut before: Option<(f64, f64)> = None;
        for _ in 0..1_000 {
            self.settle(CLOSE.1);
            self.tell(Target::Stress(wanted), watch)?;
            let now = self.packed().mean_stress;
            if (now - wanted).abs() <= MET * wanted {
                // Settled for good, it may still give way.
                self.settle(20 * CLOSE.1);
                let rest = self.packed().mean_stress;
                if (rest - wanted).abs() <= 2.0 * MET * wanted {
                    return Ok(());
                }
            }
            // Once the particles carry, the stiffness of the packing tells how far to go.
            step = match before {
                Some((share, stress)) if now > 0.05 * wanted && (now - stress) * (self.share - share) > 0.0 => {
                    let slope = (now - stress) / (self.share - share);
                    ((wanted - now) / slope / self.share).clamp(-CLOSE.0, CLOSE.0)
                }
                _ if now > wanted => -0.5 * step.abs(),
                _ => step.abs().max(1e-5),
            };
            before = Some((self.share, now));
            if self.fraction() > 0.95 {
                break;
            }
            self.grow(1.0 + step);
        }
        Err(PackingError::NotReached { what: "stress", fraction: self.fraction() })
    }

    /// Multiplies all radii.
    fn grow(&mut self, factor: f64) {
        self.share *= factor;
        for disc in &mut self.state.particles.discs {
            disc.radius *= factor;
            disc.inverse_mass /= factor * factor;
        }
        self.state.particles.travel = f64::INFINITY;
    }

    fn run(&mut self, steps: u64) {
        for _ in 0..steps {
            step(self.model, &mut self.state, &mut self.work, &self.settings);
        }
    }

    /// Steps until the particles have settled, or for `most` steps.
    fn settle(&mut self, most: u64) {
        const LOOK: u64 = 50;
        let mut taken = 0;
        while taken < most {
            self.run(LOOK);
            taken += LOOK;
            // Sum of the contact forces [N/m].
            let mut pressed = 0.0;
            self.state.particles.each_force(|compression, _, _| pressed += compression);
            if self.state.particles.unbalanced() <= SETTLED * pressed {
                break;
            }
        }
    }

    fn packed(&self) -> Packed {
        let count = self.state.particles.discs.len();
        let mut touching = vec![0u32; count];
        let mut virial = 0.0;
        self.state.particles.each_force(|compression, branch, (i, j)| {
            if compression > 0.0 {
                virial += compression * branch;
                touching[i] += 1;
                if let Some(j) = j {
                    touching[j] += 1;
                }
            }
        });
        let contacts: u32 = touching.iter().sum();
        Packed {
            solid_fraction: self.fraction(),
            coordination: f64::from(contacts) / count as f64,
            mean_stress: 0.5 * virial / self.area,
            rattlers: touching.iter().filter(|&&n| n < 2).count() as f64 / count as f64,
        }
    }

    fn tell(&self, target: Target, watch: &mut dyn Watch) -> Result<(), PackingError> {
        let goal = match target {
            Target::SolidFraction(fraction) => fraction,
            Target::Stress(_) => 0.84,
        };
        let fraction = ((self.fraction() - STREWN * STREWN) / (goal - STREWN * STREWN)).clamp(0.0, 1.0);
        let progress = Progress {
            stage: format!("packing, solid fraction {:.3}", self.fraction()),
            fraction: Some(fraction),
            steps: self.state.steps,
        };
        if watch.look(&progress) == Wish::Stop { Err(PackingError::Stopped) } else { Ok(()) }
    }

    fn finish(self) -> Packing {
        let grain = |d: &Disc| Grain { centre: d.centre(), radius: d.radius };
        let rows = &self.model.particles.rows;
        Packing {
            grains: rows.iter().map(|&row| grain(&self.state.particles.discs[row as usize])).collect(),
            packed: self.packed(),
            steps: self.state.steps,
        }
    }
}

/// Numbers that look like chance and are the same on every machine (Steele, Lea and Flood 2014: SplitMix64).
struct Chance(u64);

impl Chance {
    /// Evenly between 0 and 1.
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }
}
