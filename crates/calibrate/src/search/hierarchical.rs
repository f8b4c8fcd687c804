//! The paper's search (railway paper, sections 3.5 and 3.6, Fig. 4): a problem of many parameters as single sweeps and
//! surfaces of two, by a hierarchy of sensitivity.
//!
//! The function `pass` is Fig. 4. What the paper leaves open is settled in `docs/theory/updating.md`.

use std::collections::VecDeque;

use crate::basis::{Basis, Halt, unless_failed};
use crate::evaluator::Evaluator;
use crate::forward::Failure;
use crate::parameter::{Parameter, Scale};
use crate::report::{Found, verify};
pub use crate::search::record::{Outcome, Pass, Settings, Stage, Status, Step, Variant};
use crate::search::surface::{Case, Minimum, surface};
use crate::search::sweep::{Sweep, ranking, sweeps};

/// Searches as the paper does.
pub fn search(evaluator: &mut Evaluator, basis: &Basis, settings: &Settings) -> Outcome {
    let mut run = Run::new(evaluator, basis, settings);
    let ended = run.passes();
    let status = match ended {
        Ok(()) => run.status(),
        Err(Halt::Stopped) => Status::Stopped,
        Err(Halt::Failed(failure)) => Status::Failed(failure),
    };
    let ranges = run.ranges.iter().map(|parameter| (parameter.lower, parameter.upper)).collect();
    let settled = run.done.last().is_some_and(|pass| pass.norm.is_finite() && pass.end == pass.start);
    Outcome { status, settled, passes: run.done, path: run.path, ranges, found: run.found }
}

/// The search on its way.
struct Run<'e, 'a> {
    evaluator: &'e mut Evaluator<'a>,
    settings: Settings,
    basis: Basis,
    ranges: Vec<Parameter>,
    model: Vec<f64>,
    done: Vec<Pass>,
    path: Vec<Step>,
    found: Option<Found>,
}

impl<'e, 'a> Run<'e, 'a> {
    fn new(evaluator: &'e mut Evaluator<'a>, basis: &Basis, settings: &Settings) -> Self {
        let ranges = evaluator.problem.parameters().to_vec();
        let model = settings.start.point(&ranges);
        let mut settings = settings.clone();
        settings.points = settings.points.max(3);
        settings.passes = settings.passes.max(1);
        // At the most: sweeps, a surface for every parameter after the first, a last sweep, refreshes and a yardstick.
        let n = ranges.len();
        let pass = (n + 1) * settings.points + (n - 1) * settings.points.pow(2) + n + 1;
        evaluator.begin(Some(settings.passes * pass + 2));
        let basis = basis.clone();
        Self { evaluator, settings, basis, ranges, model, done: Vec::new(), path: Vec::new(), found: None }
    }

    /// Pass after pass, until one ends where it began or all are made; the better end is verified.
    fn passes(&mut self) -> Result<(), Halt> {
        self.step("start", None);
        let mut widened = false;
        for number in 1..=self.settings.passes {
            self.pass(number)?;
            if let Some(limits) =
                self.settings.widened.clone().filter(|_| !widened && self.present().failed_pair.is_some())
            {
                widened = true;
                self.widen(&limits);
                self.pass(number)?;
            }
            if self.done.last().is_some_and(|pass| pass.end == pass.start) {
                break;
            }
        }
        let best = self.done.iter().min_by(|a, b| a.norm.total_cmp(&b.norm));
        if let Some((end, norm, frozen)) = best.map(|pass| (pass.end.clone(), pass.norm, pass.frozen.clone())) {
            let inside = |k: usize| frozen[k] && !self.ranges[k].at_bound(end[k]);
            let converged: Vec<bool> = (0..end.len()).map(inside).collect();
            self.found = Some(verify(self.evaluator, &self.basis, &self.ranges, &end, norm, &converged)?);
        }
        Ok(())
    }

    /// Fig. 4, once through.
    fn pass(&mut self, number: usize) -> Result<(), Halt> {
        let n = self.ranges.len();
        let start = self.model.clone();
        self.done.push(Pass {
            start,
            frozen: vec![false; n],
            end: self.model.clone(),
            norm: f64::INFINITY,
            ..Pass::default()
        });
        self.refresh()?;

        self.sweep_every_parameter(number)?;
        let mut to_come = self.hierarchy();
        self.try_naive_combination()?;
        self.move_lesser_parameters_to_their_minima(&to_come);

        let mut carried = None;
        while let Some(primary) = carried.take().or_else(|| to_come.pop_front()) {
            let Some(secondary) = to_come.pop_front() else {
                self.sweep_last(number, primary)?;
                break;
            };
            carried = self.vary_pair(number, primary, secondary)?;
        }
        let set_aside: Vec<usize> = self.present().stages.iter().filter_map(|stage| stage.set_aside).collect();
        for parameter in set_aside {
            self.sweep_last(number, parameter)?;
        }
        self.end_pass()
    }

    fn sweep_every_parameter(&mut self, number: usize) -> Result<(), Halt> {
        self.evaluator.stage = format!("pass {number}: single sweeps");
        let all: Vec<usize> = (0..self.ranges.len()).collect();
        let sweeps = self.sweep(&all)?;
        let weights = self.basis.held.weights.clone();
        let pass = self.present();
        pass.ranking = ranking(&sweeps, Sweep::range);
        pass.ranking_by_channels = ranking(&sweeps, |sweep| sweep.mean_error_range(&weights));
        pass.sweeps = sweeps;
        Ok(())
    }

    /// The order in which parameters are taken up.
    fn hierarchy(&mut self) -> VecDeque<usize> {
        let variant = self.settings.variant;
        let pass = self.present();
        let (first, rest) = pass.ranking.split_at(pass.ranking.len().min(2));
        let rest: Vec<usize> = match variant {
            Variant::Printed => rest.to_vec(),
            Variant::AsPractised => pass.ranking_by_channels.iter().copied().filter(|p| !first.contains(p)).collect(),
        };
        first.iter().copied().chain(rest).collect()
    }

    fn try_naive_combination(&mut self) -> Result<(), Halt> {
        let point: Vec<f64> = self.present().sweeps.iter().map(Sweep::best).collect();
        self.present().naive_norm = self.norm_at(&point)?;
        Ok(())
    }

    /// All but the first two go to the minimum of their own sweep.
    fn move_lesser_parameters_to_their_minima(&mut self, order: &VecDeque<usize>) {
        for parameter in order.iter().skip(2) {
            self.model[*parameter] = self.present().sweeps[*parameter].best();
        }
        self.step("lesser parameters at their own minima", None);
    }

    /// One surface and the three cases; gives the parameter to carry on.
    fn vary_pair(&mut self, number: usize, primary: usize, secondary: usize) -> Result<Option<usize>, Halt> {
        let names = [primary, secondary].map(|parameter| self.ranges[parameter].name.clone());
        self.evaluator.stage = format!("pass {number}: {} with {}", names[0], names[1]);
        let (pair, about) = ([primary, secondary], (&self.ranges[..], &self.model[..]));
        let surface = surface(self.evaluator, &self.basis, about, pair, self.settings.points)?;
        let Some(surface) = surface else {
            let message = format!("the model fails on the whole surface of {} and {}", names[0], names[1]);
            return Err(Halt::Failed(Failure::new("no-surface", message)));
        };
        self.model = surface.best();
        self.step(&format!("{} with {}", names[0], names[1]), Some(surface.norm()));

        let resolved = surface.minima.map(|minimum| self.resolves(&minimum));
        let (frozen, carried, set_aside) = match resolved {
            [true, true] => (vec![primary, secondary], None, None),
            [true, false] => (vec![primary], Some(secondary), None),
            [false, true] => (vec![secondary], Some(primary), None),
            [false, false] => (vec![], Some(primary), Some(secondary)),
        };
        let pass = self.present();
        if surface.case == Case::BothAtBound && frozen.is_empty() {
            pass.failed_pair = Some(pair);
        }
        for parameter in &frozen {
            pass.frozen[*parameter] = true;
        }
        let froze = !frozen.is_empty();
        pass.stages.push(Stage { surface, frozen, carried, set_aside });
        if froze {
            self.refresh()?;
        }
        Ok(carried)
    }

    /// Whether a minimum lets its parameter be frozen.
    fn resolves(&self, minimum: &Minimum) -> bool {
        match self.settings.variant {
            Variant::Printed => minimum.decided && !minimum.at_bound,
            Variant::AsPractised => minimum.decided,
        }
    }

    /// A last single sweep of a parameter that no pair resolved.
    fn sweep_last(&mut self, number: usize, parameter: usize) -> Result<(), Halt> {
        let name = self.ranges[parameter].name.clone();
        self.evaluator.stage = format!("pass {number}: last sweep of {name}");
        for sweep in self.sweep(&[parameter])? {
            self.model[parameter] = sweep.best();
            self.step(&format!("last sweep of {name}"), Some(sweep.least()).filter(|norm| norm.is_finite()));
            let frozen = sweep.minimum.is_some_and(|minimum| self.resolves(&minimum));
            let pass = self.present();
            pass.frozen[parameter] = frozen;
            pass.last.push(sweep);
        }
        Ok(())
    }

    fn end_pass(&mut self) -> Result<(), Halt> {
        let point = self.model.clone();
        let norm = self.norm_at(&point)?.unwrap_or(f64::INFINITY);
        let pass = self.present();
        (pass.end, pass.norm) = (point, norm);
        Ok(())
    }

    /// The norm at a point; none where the model failed.
    fn norm_at(&mut self, point: &[f64]) -> Result<Option<f64>, Halt> {
        let fits = self.basis.fits(self.evaluator, &[point.to_vec()])?;
        Ok(fits[0].as_ref().map(|fit| fit.norm))
    }

    fn sweep(&mut self, parameters: &[usize]) -> Result<Vec<Sweep>, Halt> {
        sweeps(self.evaluator, &self.basis, (&self.ranges, &self.model), parameters, self.settings.points)
    }

    /// Looks for the peaks' places anew, by a full passage of the model at hand; where that passage fails, the places
    /// stay as they are.
    fn refresh(&mut self) -> Result<(), Halt> {
        if let Some(basis) = unless_failed(self.basis.refreshed(self.evaluator, &self.model))? {
            self.basis = basis;
        }
        Ok(())
    }

    fn widen(&mut self, limits: &[(f64, f64)]) {
        for (range, (lower, upper)) in self.ranges.iter_mut().zip(limits) {
            let above_zero = range.scale == Scale::Linear || *lower > 0.0;
            range.lower = if lower.is_finite() && above_zero { range.lower.min(*lower) } else { range.lower };
            range.upper = if upper.is_finite() { range.upper.max(*upper) } else { range.upper };
        }
    }

    fn present(&mut self) -> &mut Pass {
        let last = self.done.len() - 1;
        &mut self.done[last]
    }

    fn step(&mut self, stage: &str, norm: Option<f64>) {
        self.path.push(Step { stage: stage.to_owned(), point: self.model.clone(), norm });
    }

    fn status(&self) -> Status {
        let Some(pass) = self.done.last() else {
            return Status::Unresolved((0..self.ranges.len()).collect());
        };
        if let Some(pair) = pass.failed_pair {
            return Status::BothAtBounds(pair);
        }
        let open: Vec<usize> = (0..pass.frozen.len()).filter(|k| !pass.frozen[*k]).collect();
        if open.is_empty() { Status::Resolved } else { Status::Unresolved(open) }
    }
}
