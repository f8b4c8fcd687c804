//! The press: a sample held below and at both sides, under a block that is loaded in steps.

use super::sample::{Part, Sample};
use super::settled::Laws;
use crate::analysis::AnalysisError;
use crate::analysis::engine::dem::settings;
use crate::analysis::engine::joints::stiffer;
use bridge::{Bridge, Calibration};
use mechanics::blocks::{BlockModel, Held, Loading, PointForce};
use mechanics::dem::{self, Frame};
use mechanics::ids::BlockId;
use mechanics::plane::{Vec2, vec2};
use mechanics::watch::Watch;
use outcome::calibration::AtRest;

/// Everything about the tests that is the same for all samples.
pub(super) struct Rig {
    pub plan: Calibration,
    pub settings: dem::Settings,
    pub laws: Laws,
}

/// What a press of one sample gave.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Pressed {
    /// How it ended.
    pub status: dem::Status,
    /// Height of the block's underside above the floor where it first rested, under its own weight [m].
    pub height: f64,
    /// Mean stress under the block [Pa] and its sinking since it first rested [m], at the start and after each step.
    pub path: Vec<[f64; 2]>,
    /// The first rest and the last.
    pub moments: Vec<AtRest>,
    pub iterations: u64,
}

impl Rig {
    /// For samples of a fill with these laws.
    pub(super) fn new(bridge: &Bridge, laws: &Laws) -> Rig {
        Rig { plan: bridge.calibration.clone(), settings: settings(bridge), laws: laws.clone() }
    }

    /// Presses a sample whose contacts among particles are `multiple` times as stiff as those of the file; everything else
    /// is as in the file.
    pub(super) fn press(
        &self,
        sample: &Sample,
        multiple: f64,
        watch: &mut dyn Watch,
    ) -> Result<Pressed, AnalysisError> {
        let (blocks, loading, watched) = self.build(sample, multiple)?;
        let program = dem::Program { increment: 1.0, limit: self.plan.steps as f64, resolution: None, watched };
        let outcome = dem::collapse(&blocks, &loading, &program, &self.settings, None, watch)?;
        let rested: Vec<&dem::PathPoint> = outcome.path.iter().filter(|point| point.at_rest).collect();
        let first = rested.first().map_or(0.0, |point| point.displacement.y);
        let weight = self.plan.block_weight;
        let at = |point: &&dem::PathPoint| {
            let load = weight + point.factor * self.plan.load_step;
            [load / sample.size, first - point.displacement.y]
        };
        let settled: Vec<&Frame> = outcome.frames[..outcome.last_stable_frame.map_or(0, |k| k + 1)].iter().collect();
        let moment = |frame: &&Frame| {
            let particles = frame.particles.iter().map(|p| [p.centre.x, p.centre.y, p.radius]).collect();
            let (block, point) = watched;
            let sunk = frame.poses[block].position - blocks.blocks[block].outline.centroid();
            AtRest { particles, block: point.y + sunk.y }
        };
        Ok(Pressed {
            status: outcome.status,
            height: watched.1.y + first,
            path: rested.iter().map(at).collect(),
            moments: settled.first().into_iter().chain(settled.last()).map(moment).collect(),
            iterations: outcome.iterations_total,
        })
    }

    /// The sample in the press, the load of a step, and the pressing block with the middle of its underside.
    fn build(&self, sample: &Sample, multiple: f64) -> Result<(BlockModel, Loading, (BlockId, Vec2)), AnalysisError> {
        let (size, thickness) = (sample.size, 0.2 * sample.size);
        let side = 1.5 * size + thickness;
        // So narrow a gap that no particle comes between the block and the walls.
        let gap = GAP * sample.smallest;
        let (top, height) = (sample.top(), 0.25 * size);
        let density = self.plan.block_weight / (self.laws.gravity.norm() * (size - 2.0 * gap) * height);
        let fixed = |low: Vec2, width: f64, height: f64| Part { low, width, height, density: 1.0, held: Held::FIXED };
        let sinking = Held { x: true, y: false, rotation: true };
        let parts = [
            fixed(vec2(0.0, -thickness), size, thickness),
            fixed(vec2(-thickness, -thickness), thickness, side),
            fixed(vec2(size, -thickness), thickness, side),
            Part { low: vec2(gap, top), width: size - 2.0 * gap, height, density, held: sinking },
        ];
        let laws = self.laws.with_contacts(|law| stiffer(&law, multiple));
        let (model, [.., (block, at)]) = sample.among(parts, laws)?;
        let force = PointForce { block, at, force: vec2(0.0, -self.plan.load_step) };
        let loading = Loading { variable: vec![force], ..Loading::default() };
        Ok((model, loading, (block, vec2(0.5 * size, top))))
    }

    /// Normal and shear stiffness [Pa/m] of contacts between particles at a multiple, for centres `distance` [m] apart.
    pub(super) fn stiffness(&self, multiple: f64, distance: f64) -> [f64; 2] {
        let Some(&layer) = self.laws.layers.first() else { return [0.0; 2] };
        let law = stiffer(self.laws.table.between(layer, layer), multiple);
        [law.normal.at(distance), law.shear.at(distance)]
    }
}

/// Gap between the pressing block and the walls, as a share of the smallest radius.
const GAP: f64 = 0.05;
