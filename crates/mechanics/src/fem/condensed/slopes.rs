//! Derivatives of what is observed by quantities of the model, along the whole path.
//!
//! Beside the model stand neighbours in which one quantity differs a little. What is in balance here is not in balance there: the linear system differs by
//! `dK u - df`, and the parts answer otherwise and remember something else. One solution with the tangent of the position tells where the neighbour's balance lies, to first
//! order, and with it what its parts remember from then on (direct differentiation; docs/theory/condensed.md, equation 6). Of each position and
//! quantity that takes one right-hand side of the linear system and one of the tangent on the rows, no iteration.

use super::parts::{Committed, Kind, Part};
use super::passage::Visited;
use super::rows::{LoadPattern, Row, Rows, dot};
use super::tangent::{StiffnessEntry, Tangent};
use super::{Condensed, CondensedError, Place};
use crate::fem::many::WIDEST;
use crate::fem::model::Model;
use crate::fem::state::State;

/// The same mesh with one quantity a little different.
#[derive(Debug, Clone, Copy)]
pub struct Neighbour<'n> {
    /// Its model.
    pub model: &'n Model,
    /// Its load patterns.
    pub patterns: &'n [LoadPattern],
    /// By how much the quantity differs, in whatever unit derivatives are wanted by.
    pub by: f64,
}

/// Derivatives of the observed functionals.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Derivatives {
    /// At the end of the path: by neighbour, then by functional.
    pub at_end: Vec<Vec<f64>>,
    /// In each of the branches, in the same shape.
    pub branches: Vec<Vec<Vec<f64>>>,
}

/// The linear system's share: what it does in each position to the rows and to what is observed.
struct Led {
    /// Values of the active rows.
    values: Vec<f64>,
    /// By neighbour: derivatives without any change of the parts' forces, of active rows and of observed functionals.
    rows: Vec<Vec<f64>>,
    observed: Vec<Vec<f64>>,
    /// Which of the active parts are broken there.
    broken: Vec<usize>,
}

/// The active parts of the model and of its neighbours, on their way.
struct Walk<'n> {
    models: Vec<&'n Model>,
    by: Vec<f64>,
    /// Of the model itself first.
    parts: Vec<Vec<Part>>,
    tangent: Tangent<f64>,
}

impl<'a> Condensed<'a> {
    /// Derivatives by quantities in which `neighbours` differ: at the end of `path`, which began with the run, and in the `branches` that were
    /// reached from there.
    pub fn derivatives(
        &mut self,
        neighbours: &[Neighbour<'_>],
        path: &[Visited],
        branches: &[Visited],
    ) -> Result<Derivatives, CondensedError> {
        let places = path.iter().chain(branches).map(|visited| visited.place.clone());
        let places: Vec<Place> = places.collect::<Option<_>>().ok_or(CondensedError::NoPlaces)?;
        if self.start.displacements.iter().chain(&self.start.forces).any(|value| *value != 0.0) {
            return Err(CondensedError::NoPlaces);
        }
        let led = self.led(neighbours, &places)?;
        let observed_rows = self.answers_of_observed();
        let mut walk = self.walk(neighbours)?;
        let mut found =
            Derivatives { at_end: vec![vec![0.0; self.observed.len()]; neighbours.len()], ..Derivatives::default() };
        for led in &led[..path.len()] {
            found.at_end = walk.to(&self.rows, led, &observed_rows).ok_or(CondensedError::Broken)?;
        }
        let at_rest = walk.remembered();
        for led in &led[path.len()..] {
            walk.restore(&at_rest);
            let branch = walk.to(&self.rows, led, &observed_rows).ok_or(CondensedError::Broken)?;
            found.branches.push(branch);
        }
        Ok(found)
    }

    /// What the linear system does in each of the places.
    fn led(&mut self, neighbours: &[Neighbour<'_>], places: &[Place]) -> Result<Vec<Led>, CondensedError> {
        self.work.stiffness(self.model, &self.start)?;
        let own = self.work.values.clone();
        let mut stiffer = Vec::with_capacity(neighbours.len());
        for neighbour in neighbours {
            self.work.stiffness(neighbour.model, &State::new(neighbour.model))?;
            let differences = self.work.values.iter().zip(&own).map(|(other, own)| (other - own) / neighbour.by);
            stiffer.push(differences.collect::<Vec<f64>>());
        }
        self.work.values.clone_from(&own);
        let heavier: Vec<Vec<Vec<(u32, f64)>>> = neighbours.iter().map(|other| self.heavier(other)).collect();
        let mut all = Vec::with_capacity(places.len());
        for places in places.chunks(WIDEST) {
            self.displace(&places.iter().collect::<Vec<_>>());
            let mut right = Vec::with_capacity(places.len() * neighbours.len());
            for (lane, place) in places.iter().enumerate() {
                let values = self.rows.list().iter().map(|row| row.start + row.change_in(&self.block, lane)).collect();
                let broken =
                    place.broken.iter().filter_map(|part| self.active.iter().position(|active| active == part));
                all.push(Led { values, rows: Vec::new(), observed: Vec::new(), broken: broken.collect() });
                let moved: Vec<f64> = (0..self.model.equations() as u32).map(|e| self.block.of(e)[lane]).collect();
                for (stiffer, heavier) in stiffer.iter().zip(&heavier) {
                    let mut force = vec![0.0; moved.len()];
                    self.work.pattern.multiply(stiffer, &[], &moved, &mut force);
                    force.iter_mut().for_each(|force| *force = -*force);
                    for (pattern, amplitude) in heavier.iter().zip(&place.amplitudes) {
                        pattern.iter().for_each(|&(equation, more)| force[equation as usize] += amplitude * more);
                    }
                    right.push(
                        force.into_iter().enumerate().map(|(equation, force)| (equation as u32, force)).collect(),
                    );
                }
            }
            let first = all.len() - places.len();
            for (chunk, right) in right.chunks(WIDEST).enumerate() {
                self.work.solve_block(right, &mut self.block);
                for lane in 0..right.len() {
                    let led = &mut all[first + (chunk * WIDEST + lane) / neighbours.len()];
                    let of = |rows: &[Row]| rows.iter().map(|row| row.change_in(&self.block, lane)).collect();
                    led.rows.push(of(self.rows.list()));
                    led.observed.push(of(&self.observed));
                }
            }
        }
        Ok(all)
    }

    /// Derivatives of the patterns.
    fn heavier(&self, neighbour: &Neighbour<'_>) -> Vec<Vec<(u32, f64)>> {
        let of = |(own, other): (&Vec<(u32, f64)>, &LoadPattern)| {
            let mut more: Vec<(u32, f64)> = own.iter().map(|&(equation, force)| (equation, -force)).collect();
            more.extend(other.on_equations(self.model));
            more.sort_unstable_by_key(|(equation, _)| *equation);
            let mut merged: Vec<(u32, f64)> = Vec::new();
            for (equation, force) in more {
                match merged.last_mut().filter(|last| last.0 == equation) {
                    Some(last) => last.1 += force,
                    None => merged.push((equation, force)),
                }
            }
            merged.retain(|(_, force)| *force != 0.0);
            merged.iter_mut().for_each(|(_, force)| *force /= neighbour.by);
            merged
        };
        self.patterns.iter().zip(neighbour.patterns).map(of).collect()
    }

    /// For each observed functional what forces on the active rows do to it.
    fn answers_of_observed(&mut self) -> Vec<Vec<f64>> {
        let mut all = Vec::with_capacity(self.observed.len());
        for some in self.observed.chunks(WIDEST) {
            let unit = |row: &Row| {
                let mut right = Vec::new();
                row.append_force(&mut right, 1.0);
                right
            };
            self.work.solve_block(&some.iter().map(unit).collect::<Vec<_>>(), &mut self.block);
            for lane in 0..some.len() {
                all.push(self.rows.list().iter().map(|row| row.change_in(&self.block, lane)).collect());
            }
        }
        all
    }

    /// The active parts as they were when the run began, here and in the neighbours.
    fn walk<'w>(&self, neighbours: &[Neighbour<'w>]) -> Result<Walk<'w>, CondensedError>
    where
        'a: 'w,
    {
        let own: Vec<Part> = self.active.iter().map(|&index| self.parts[index].clone()).collect();
        let mut parts = vec![own];
        parts[0].iter_mut().for_each(|part| part.revert_to_start(&self.start));
        for neighbour in neighbours {
            let start = State::new(neighbour.model);
            let there = |own: &Part| {
                let mut part = match own.kind {
                    Kind::Spring(index) => Part::spring(neighbour.model, &start, index),
                    Kind::Quad(id) => Part::quad(neighbour.model, &start, id)?,
                };
                part.set_initial_excess(neighbour.model)?;
                part.rows = own.rows;
                Some(part)
            };
            let there: Option<Vec<Part>> = parts[0].iter().map(there).collect();
            parts.push(there.ok_or(CondensedError::Broken)?);
        }
        let models = std::iter::once(self.model).chain(neighbours.iter().map(|other| other.model)).collect();
        let by = neighbours.iter().map(|other| other.by).collect();
        Ok(Walk { models, by, parts, tangent: Tangent::default() })
    }
}

impl Walk<'_> {
    /// Goes on to a place; derivatives of the observed functionals there, by neighbour. `None` where a part has no answer.
    fn to(&mut self, rows: &Rows, led: &Led, observed: &[Vec<f64>]) -> Option<Vec<Vec<f64>>> {
        let Walk { models, by, parts, tangent } = self;
        for parts in parts.iter_mut() {
            led.broken.iter().for_each(|&part| parts[part].break_spring());
        }
        let (own, others) = parts.split_first_mut()?;
        let mut slopes: Vec<StiffnessEntry> = Vec::new();
        for part in own.iter_mut() {
            part.evaluate(models[0], |row| led.values[row])?;
            if !part.linear {
                part.for_each_stiffness_entry(|p, q, s| slopes.push((p, q, s)));
            }
        }
        tangent.factorise_for(&slopes, rows.flexibility_rows());
        let mut found = Vec::with_capacity(others.len());
        for (k, parts) in others.iter_mut().enumerate() {
            let model = models[1 + k];
            // What the neighbour's parts answer otherwise at the same displacements, with what they remember.
            let mut right = vec![0.0; rows.len()];
            for (own, other) in own.iter().zip(parts.iter_mut()) {
                other.evaluate(model, |row| led.values[row])?;
                for (i, row) in own.rows.iter().enumerate() {
                    if let Some(row) = row {
                        right[*row] += (other.excess[i] - own.excess[i]) / by[k];
                    }
                }
            }
            let mut given = right.clone();
            tangent.nonlinear_rows.iter().for_each(|&row| given[row] = 0.0);
            let mut values = led.rows[k].clone();
            rows.add_row_changes(&mut values, given.into_iter().enumerate());
            let step = tangent.solve(&right, &values);
            rows.add_row_changes(&mut values, tangent.nonlinear_rows.iter().map(|&row| (row, step[row])));
            found.push(led.observed[k].iter().zip(observed).map(|(led, row)| led + dot(row, &step)).collect());
            for part in parts {
                part.evaluate(model, |row| led.values[row] + by[k] * values[row])?;
                part.commit();
            }
        }
        for part in own {
            part.commit();
        }
        Some(found)
    }

    fn remembered(&self) -> Vec<Vec<Committed>> {
        self.parts.iter().map(|parts| parts.iter().map(Part::committed).collect()).collect()
    }

    fn restore(&mut self, remembered: &[Vec<Committed>]) {
        for (part, remembered) in self.parts.iter_mut().flatten().zip(remembered.iter().flatten()) {
            part.restore(remembered);
        }
    }
}
