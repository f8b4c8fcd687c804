//! Vehicles on fill that yields as a continuum. Rigid blocks with fill as weight are answered first and everywhere: they tell which axles, which
//! uniform loads and which weights govern at a position. On the continuum these and the whole vehicle are asked at up to some fifty positions of
//! each drive, the least lower bound first; then every combination of weights at the worst position, and the positions on both sides of it
//! that were left out. The smaller factor counts everywhere.

use super::super::engine::continuum::Moving as Body;
use super::super::engine::continuum::moved::{self, Asked};
use super::super::parallel::portion;
use super::traffic::Traffic;
use super::{AnalysisError, factored};
use crate::vehicles::Chosen;
use mechanics::watch::Watch;
use outcome::collapse::Status;
use outcome::vehicles::{Case, EnvelopePoint, Swept, Weights};
use structure::discretise::continuum;

/// Upper over lower bound of the least factor, where the file wants no more.
const RATIO: f64 = 1.1;

/// Most positions of a drive that are asked before the worst one is known.
const POSITIONS: usize = 49;

/// Puts lower bounds on the continuum in front where they are the smaller factors. Tells whether all of it was done.
pub(super) fn beside(traffic: &Traffic<'_>, swept: &mut [Swept], watch: &mut dyn Watch) -> Result<bool, AnalysisError> {
    let built = traffic.bridges.iter().zip(&traffic.built);
    let bodies: Vec<Body<'_>> = built.map(|(own, d)| Body::new(own, d)).collect::<Result<_, _>>()?;
    let own = traffic.own();
    let count = own.len() as f64;
    for (n, &k) in own.iter().enumerate() {
        let one = One { traffic, bodies: &bodies, chosen: &traffic.vehicles[k] };
        let part = &mut portion(watch, [n as f64 / count, (n + 1) as f64 / count]);
        if !one.judged(&mut swept[k], part)? {
            return Ok(false);
        }
    }
    traffic.told_alike(swept, Swept::yields_like);
    Ok(true)
}

/// One vehicle.
struct One<'a> {
    traffic: &'a Traffic<'a>,
    bodies: &'a [Body<'a>],
    chosen: &'a Chosen,
}

/// Loads that are asked: at which point of the envelope, and what stands there.
struct Stands {
    point: usize,
    case: Case,
}

impl One<'_> {
    /// Asks for a vehicle and takes what comes of it; whether all was answered.
    fn judged(&self, swept: &mut Swept, watch: &mut dyn Watch) -> Result<bool, AnalysisError> {
        let drives = drives(&swept.envelope);
        let stride = |drive: &[usize]| drive.len().div_ceil(POSITIONS).max(1);
        let first: Vec<Stands> =
            drives.iter().flat_map(|d| d.iter().step_by(stride(d))).flat_map(|&k| self.at(swept, k)).collect();
        let Some(worst) = self.asked(swept, first, &mut portion(watch, [0.0, 0.8]))? else { return Ok(false) };
        if let Some((_, at)) = worst {
            let drive = drives.iter().find(|drive| drive.contains(&at.point)).map_or(&[][..], Vec::as_slice);
            let step = stride(drive);
            let place = drive.iter().position(|k| *k == at.point).unwrap_or(0);
            let beside = drive.iter().enumerate().filter(|(n, _)| *n != place && n.abs_diff(place) < step);
            let like = |point: usize, weights: Weights| {
                let position = swept.envelope[point].case.position;
                Stands { point, case: Case { position, weights, ..at.case.clone() } }
            };
            let others = self.traffic.weights.iter().filter(|w| **w != at.case.weights).map(|w| like(at.point, *w));
            let second: Vec<Stands> = beside.map(|(_, &k)| like(k, at.case.weights)).chain(others).collect();
            if self.asked(swept, second, &mut portion(watch, [0.8, 1.0]))?.is_none() {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// What governs at a point where fill is weight, and the whole vehicle.
    fn at(&self, swept: &Swept, point: usize) -> Vec<Stands> {
        let p = &swept.envelope[point];
        let Some(pattern) = factored::pattern(self.chosen, &p.case.arrangement) else { return Vec::new() };
        let governing = Case { horizontal: 0.0, ..self.traffic.governing(p) };
        let axles = pattern.axles.len().checked_sub(1).map(|last| [0, last]);
        // As far as the fill reaches.
        let uniform = self.bodies.first().map(|body| body.earth.ends).filter(|_| !pattern.stretches.is_empty());
        let whole = Case { axles, uniform, ..governing.clone() };
        let stands = |case: &Case| case.axles.is_some() || case.uniform.is_some();
        let both = if governing == whole { vec![whole] } else { vec![whole, governing] };
        both.into_iter().filter(stands).map(|case| Stands { point, case }).collect()
    }

    /// Asks, takes the smaller factors, and gives the least with what stands there; none where it was broken off.
    fn asked(
        &self,
        swept: &mut Swept,
        stands: Vec<Stands>,
        watch: &mut dyn Watch,
    ) -> Result<Option<Worst>, AnalysisError> {
        let mut rows: Vec<(Case, usize)> = Vec::new();
        let mut asked = Vec::with_capacity(stands.len());
        let mut all = Vec::with_capacity(stands.len());
        for mut one in stands {
            let body = self.traffic.weights.iter().position(|w| *w == one.case.weights).unwrap_or(0);
            let Traffic { bridges, plan, rule, .. } = self.traffic;
            let bridge = factored::with_case(&bridges[body], plan, rule, self.chosen, &one.case);
            let strips = continuum::loads(&bridge);
            one.case.load = strips.iter().map(|strip| strip.force).sum();
            // Uniform loads do not move with the vehicle; axles do.
            let kind = Case { position: 0.0, load: 0.0, ..one.case.clone() };
            let row = rows.iter().position(|row| *row == (kind.clone(), body)).unwrap_or_else(|| {
                rows.push((kind, body));
                rows.len() - 1
            });
            asked.push(Asked { body, row, position: one.case.position, strips });
            all.push(one);
        }
        let ratio = self.bodies.first().map_or(RATIO, |body| body.earth.plan.bound_ratio).max(RATIO);
        let (answers, done) = moved::all(self.bodies, &asked, ratio, watch)?;
        if !done {
            return Ok(None);
        }
        let mut worst: Worst = None;
        for (one, answer) in all.into_iter().zip(answers.into_iter().flatten()) {
            let factor = answer.found.lower.map(|lower| lower * self.traffic.rule.capacity_factor());
            swept.yields(one.point, &one.case, (answer.found.status, factor));
            if let Some(factor) = factor.filter(|_| answer.found.status == Status::Collapsed)
                && worst.as_ref().is_none_or(|(before, _)| factor < *before)
            {
                worst = Some((factor, one));
            }
        }
        Ok(Some(worst))
    }
}

/// The least factor found, and what stands there.
type Worst = Option<(f64, Stands)>;

/// The points of an envelope, drive by drive, from left to right.
fn drives(envelope: &[EnvelopePoint]) -> Vec<Vec<usize>> {
    let mut drives: Vec<Vec<usize>> = Vec::new();
    for (k, point) in envelope.iter().enumerate() {
        let same = |drive: &&mut Vec<usize>| {
            let (first, case) = (&envelope[drive[0]].case, &point.case);
            (&first.arrangement, first.direction) == (&case.arrangement, case.direction)
        };
        match drives.iter_mut().find(same) {
            Some(drive) => drive.push(k),
            None => drives.push(vec![k]),
        }
    }
    for drive in &mut drives {
        drive.sort_by(|a, b| envelope[*a].case.position.total_cmp(&envelope[*b].case.position));
    }
    drives
}
