//! Derivatives of the observed functionals by quantities of the model, along the whole path (direct differentiation;
//! docs/theory/condensed.md, equation 7).
//!
//! For each quantity there is a perturbed model, in which the quantity differs a little. At the displacements of the model it is
//! out of balance: by `dK u - df` of the linear system, and by the difference of the excess forces, with the history of each. One
//! solution with the tangent of the position gives the derivatives of the displacements, and with them the history of the
//! perturbed parts goes on. That takes one right-hand side of the linear system and one of the tangent for each position and
//! quantity, and no iteration.

use super::parts::{Committed, Kind, Part};
use super::passage::Visited;
use super::rows::{LoadPattern, Row, Rows, dot, on_equations};
use super::tangent::{StiffnessEntry, Tangent};
use super::{Condensed, CondensedError, Equilibrium};
use crate::fem::many::WIDEST;
use crate::fem::model::Model;
use crate::fem::state::State;
use crate::watch::{Asking, Watch};

/// The same mesh with one quantity a little different.
#[derive(Debug, Clone, Copy)]
pub struct PerturbedModel<'n> {
    /// Its model.
    pub model: &'n Model,
    /// Its load patterns.
    pub patterns: &'n [LoadPattern],
    /// Difference of the quantity, in the unit by which derivatives are wanted.
    pub by: f64,
}

/// Derivatives of the observed functionals.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Derivatives {
    /// At the end of the path: by perturbed model, then by functional.
    pub at_end: Vec<Vec<f64>>,
    /// In each of the branches, in the same shape.
    pub branches: Vec<Vec<Vec<f64>>>,
}

/// What the linear system gives for one position.
struct Response {
    /// Values of the retained rows [m].
    values: Vec<f64>,
    /// By perturbed model: derivatives of retained row values and of observed functionals, without any change of the excess
    /// forces.
    row_derivatives: Vec<Vec<f64>>,
    observed_derivatives: Vec<Vec<f64>>,
    /// Retained parts that broke there, by their number among the retained ones.
    broken: Vec<usize>,
}

/// The retained parts of the model and of the perturbed models, as the path goes on.
struct Differentiated<'n> {
    models: Vec<&'n Model>,
    by: Vec<f64>,
    /// Parts of the model itself first.
    parts: Vec<Vec<Part>>,
    tangent: Tangent<f64>,
}

impl Condensed {
    /// Gives the derivatives by the quantities in which `perturbed` differ: at the end of `path`, which began with the run, and
    /// in the `branches` that were solved from there. `None` where the onlooker stops it.
    ///
    /// # Errors
    /// Equilibria that were not kept, a start with displacements or forces, or a part that has no answer.
    pub fn derivatives(
        &mut self,
        perturbed: &[PerturbedModel<'_>],
        path: &[Visited],
        branches: &[Visited],
        watch: &mut dyn Watch,
    ) -> Result<Option<Derivatives>, CondensedError> {
        let mut asking = Asking::new(watch);
        let equilibria = path.iter().chain(branches).map(|visited| visited.equilibrium.clone());
        let equilibria: Vec<Equilibrium> = equilibria.collect::<Option<_>>().ok_or(CondensedError::NoEquilibria)?;
        if self.start.displacements.iter().chain(&self.start.forces).any(|value| *value != 0.0) {
            return Err(CondensedError::NoEquilibria);
        }
        let Some(responses) = self.linear_responses(perturbed, &equilibria, &mut asking)? else { return Ok(None) };
        let observed_rows = self.observed_flexibility();
        let mut differentiated = self.differentiated(perturbed)?;
        let mut found =
            Derivatives { at_end: vec![vec![0.0; self.observed.len()]; perturbed.len()], ..Derivatives::default() };
        for response in &responses[..path.len()] {
            if asking.stops() {
                return Ok(None);
            }
            found.at_end =
                differentiated.advance(&self.rows, response, &observed_rows).ok_or(CondensedError::Broken)?;
        }
        let start = differentiated.committed();
        for response in &responses[path.len()..] {
            if asking.stops() {
                return Ok(None);
            }
            differentiated.restore(&start);
            let branch = differentiated.advance(&self.rows, response, &observed_rows).ok_or(CondensedError::Broken)?;
            found.branches.push(branch);
        }
        Ok(Some(found))
    }

    /// Solves the linear system for each of the equilibria; `None` where `asking` stops it.
    fn linear_responses(
        &mut self,
        perturbed: &[PerturbedModel<'_>],
        equilibria: &[Equilibrium],
        asking: &mut Asking<'_>,
    ) -> Result<Option<Vec<Response>>, CondensedError> {
        self.work.stiffness(&self.model, &self.start)?;
        let own = self.work.values.clone();
        let mut stiffness_derivatives = Vec::with_capacity(perturbed.len());
        for other in perturbed {
            self.work.stiffness(other.model, &State::new(other.model))?;
            let differences = self.work.values.iter().zip(&own).map(|(theirs, own)| (theirs - own) / other.by);
            stiffness_derivatives.push(differences.collect::<Vec<f64>>());
        }
        self.work.values.clone_from(&own);
        let pattern_derivatives: Vec<Vec<Vec<(u32, f64)>>> =
            perturbed.iter().map(|other| self.pattern_derivatives(other)).collect();
        let mut all = Vec::with_capacity(equilibria.len());
        for equilibria in equilibria.chunks(WIDEST) {
            self.solve_full_system(&equilibria.iter().collect::<Vec<_>>());
            let mut right = Vec::with_capacity(equilibria.len() * perturbed.len());
            for (lane, equilibrium) in equilibria.iter().enumerate() {
                let values = self.rows.list.iter().map(|row| row.start + row.change_in(&self.block, lane)).collect();
                let broken = equilibrium
                    .broken
                    .iter()
                    .filter_map(|part| self.retained.iter().position(|retained| retained == part));
                all.push(Response {
                    values,
                    row_derivatives: Vec::new(),
                    observed_derivatives: Vec::new(),
                    broken: broken.collect(),
                });
                let displacements = self.block.solution(lane);
                for (stiffness_derivatives, pattern_derivatives) in
                    stiffness_derivatives.iter().zip(&pattern_derivatives)
                {
                    let mut force = vec![0.0; displacements.len()];
                    self.work.pattern.multiply(stiffness_derivatives, &[], &displacements, &mut force);
                    force.iter_mut().for_each(|force| *force = -*force);
                    for (pattern, amplitude) in pattern_derivatives.iter().zip(&equilibrium.amplitudes) {
                        pattern.iter().for_each(|&(equation, more)| force[equation as usize] += amplitude * more);
                    }
                    right.push(
                        force.into_iter().enumerate().map(|(equation, force)| (equation as u32, force)).collect(),
                    );
                }
            }
            let first = all.len() - equilibria.len();
            for (chunk, right) in right.chunks(WIDEST).enumerate() {
                if asking.stops() {
                    return Ok(None);
                }
                self.work.solver.solve_block(right, None, &mut self.block);
                for lane in 0..right.len() {
                    let response = &mut all[first + (chunk * WIDEST + lane) / perturbed.len()];
                    let of = |rows: &[Row]| rows.iter().map(|row| row.change_in(&self.block, lane)).collect();
                    response.row_derivatives.push(of(&self.rows.list));
                    response.observed_derivatives.push(of(&self.observed));
                }
            }
        }
        Ok(Some(all))
    }

    /// Gives the derivatives of the load patterns, by equations [N/m by the unit of the quantity].
    fn pattern_derivatives(&self, perturbed: &PerturbedModel<'_>) -> Vec<Vec<(u32, f64)>> {
        let of = |(own, other): (&Vec<(u32, f64)>, &LoadPattern)| {
            let mut more: Vec<(u32, f64)> = own.iter().map(|&(equation, force)| (equation, -force)).collect();
            more.extend(on_equations(&self.model, other));
            more.sort_unstable_by_key(|(equation, _)| *equation);
            let mut merged: Vec<(u32, f64)> = Vec::new();
            for (equation, force) in more {
                match merged.last_mut().filter(|last| last.0 == equation) {
                    Some(last) => last.1 += force,
                    None => merged.push((equation, force)),
                }
            }
            merged.retain(|(_, force)| *force != 0.0);
            merged.iter_mut().for_each(|(_, force)| *force /= perturbed.by);
            merged
        };
        self.patterns.iter().zip(perturbed.patterns).map(of).collect()
    }

    /// Gives, for each observed functional, its values for unit forces on the retained rows [m²/N].
    fn observed_flexibility(&mut self) -> Vec<Vec<f64>> {
        let mut all = Vec::with_capacity(self.observed.len());
        for some in self.observed.chunks(WIDEST) {
            let units: Vec<_> = some.iter().map(|row| row.terms.clone()).collect();
            self.work.solver.solve_block(&units, None, &mut self.block);
            for lane in 0..some.len() {
                all.push(self.rows.list.iter().map(|row| row.change_in(&self.block, lane)).collect());
            }
        }
        all
    }

    /// Gives the retained parts as they were when the run began, in the model and in the perturbed models.
    fn differentiated<'w>(&'w self, perturbed: &[PerturbedModel<'w>]) -> Result<Differentiated<'w>, CondensedError> {
        let own: Vec<Part> = self.retained.iter().map(|&index| self.parts[index].clone()).collect();
        let mut parts = vec![own];
        parts[0].iter_mut().for_each(|part| part.revert_to_start(&self.start));
        for perturbed in perturbed {
            let start = State::new(perturbed.model);
            let perturb = |own: &Part| {
                let mut part = match own.kind {
                    Kind::Spring(index) => Part::spring(perturbed.model, &start, index),
                    Kind::Quad(id) => Part::quad(perturbed.model, &start, id)?,
                };
                part.set_initial_excess(perturbed.model)?;
                part.rows = own.rows;
                Some(part)
            };
            let perturbed_parts: Option<Vec<Part>> = parts[0].iter().map(perturb).collect();
            parts.push(perturbed_parts.ok_or(CondensedError::Broken)?);
        }
        let models = std::iter::once(&*self.model).chain(perturbed.iter().map(|other| other.model)).collect();
        let by = perturbed.iter().map(|other| other.by).collect();
        Ok(Differentiated { models, by, parts, tangent: Tangent::default() })
    }
}

impl Differentiated<'_> {
    /// Goes on to the next position; gives the derivatives of the observed functionals there, by perturbed model. `None` where a
    /// law has no answer.
    fn advance(&mut self, rows: &Rows, response: &Response, observed: &[Vec<f64>]) -> Option<Vec<Vec<f64>>> {
        let Differentiated { models, by, parts, tangent } = self;
        for parts in parts.iter_mut() {
            response.broken.iter().for_each(|&part| parts[part].break_spring());
        }
        let (own, others) = parts.split_first_mut()?;
        let mut stiffness: Vec<StiffnessEntry> = Vec::new();
        for part in own.iter_mut() {
            part.evaluate(models[0], |row| response.values[row])?;
            if !part.linear {
                part.for_each_stiffness_entry(|p, q, s| stiffness.push((p, q, s)));
            }
        }
        tangent.factorise_for(&stiffness, &rows.flexibility);
        let mut found = Vec::with_capacity(others.len());
        for (k, parts) in others.iter_mut().enumerate() {
            let model = models[1 + k];
            // Excess forces of the perturbed parts at the same displacements, with their own history.
            let mut right = vec![0.0; rows.len()];
            for (own, other) in own.iter().zip(parts.iter_mut()) {
                other.evaluate(model, |row| response.values[row])?;
                for (i, row) in own.rows.iter().enumerate() {
                    if let Some(row) = row {
                        right[*row] += (other.excess[i] - own.excess[i]) / by[k];
                    }
                }
            }
            let mut known_step = right.clone();
            tangent.nonlinear_rows.iter().for_each(|&row| known_step[row] = 0.0);
            let mut values = response.row_derivatives[k].clone();
            rows.add_row_changes(&mut values, known_step.into_iter().enumerate());
            let step = tangent.solve(&right, &values);
            rows.add_row_changes(&mut values, tangent.nonlinear_rows.iter().map(|&row| (row, step[row])));
            found.push(
                response.observed_derivatives[k]
                    .iter()
                    .zip(observed)
                    .map(|(derivative, row)| derivative + dot(row, &step))
                    .collect(),
            );
            for part in parts {
                part.evaluate(model, |row| response.values[row] + by[k] * values[row])?;
                part.commit();
            }
        }
        for part in own {
            part.commit();
        }
        Some(found)
    }

    /// Gives the committed states of all parts.
    fn committed(&self) -> Vec<Vec<Committed>> {
        self.parts.iter().map(|parts| parts.iter().map(|part| part.committed).collect()).collect()
    }

    /// Restores committed states of all parts.
    fn restore(&mut self, committed: &[Vec<Committed>]) {
        for (part, committed) in self.parts.iter_mut().flatten().zip(committed.iter().flatten()) {
            part.committed = *committed;
        }
    }
}
