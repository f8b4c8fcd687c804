//! One increment of the loads: iterations, activation of dormant parts, springs that break.

use super::newton::Trial;
use super::parts::Committed;
use super::{Condensed, Equilibrium, Position, Reached};
use crate::fem::joint::weakest;
use crate::watch::Asking;

/// Steps like the last one by which row values are extrapolated to predict which dormant parts become nonlinear. Without the
/// prediction a passage takes half as many iterations again.
const EXTRAPOLATION: f64 = 2.0;

/// What changed on the way to a position.
#[derive(Debug, Default)]
pub(super) struct UndoLog {
    /// States of parts before each change, in the order of the changes.
    pub states: Vec<(usize, Committed)>,
    /// Equilibria in which springs broke. Eliminated parts are rechecked there, too, as one of them may have to break first.
    pub breaks: Vec<Equilibrium>,
}

impl Condensed {
    /// Solves for the equilibrium under loads of given `amplitudes`, from the current one, with the retained parts. Changes are
    /// written to `undo_log`; where no equilibrium is found, all of them are undone.
    pub(super) fn solve_increment(
        &mut self,
        amplitudes: Vec<f64>,
        undo_log: &mut UndoLog,
        asking: &mut Asking<'_>,
    ) -> Position {
        let (states, breaks, broken) = (undo_log.states.len(), undo_log.breaks.len(), self.current.broken.len());
        let position = self.iterate_to_equilibrium(amplitudes, undo_log, asking);
        if position.reached != Reached::Balanced {
            self.current.broken.truncate(broken);
            undo_log.breaks.truncate(breaks);
            undo_log.states.drain(states..).rev().for_each(|(part, state)| self.parts[part].committed = state);
        }
        position
    }

    /// Iterates to the equilibrium, activating dormant parts and breaking springs; where none is found, broken springs stay
    /// broken.
    fn iterate_to_equilibrium(
        &mut self,
        amplitudes: Vec<f64>,
        undo_log: &mut UndoLog,
        asking: &mut Asking<'_>,
    ) -> Position {
        let mut position = Position { reached: Reached::NotConverged, iterations: 0, residual: f64::INFINITY };
        let predicted = std::mem::take(&mut self.predicted_active);
        self.active_set.add(predicted.into_iter(), &self.parts, &self.rows);
        let increments: Vec<f64> =
            amplitudes.iter().zip(&self.current.amplitudes).map(|(to, from)| to - from).collect();
        let mut trial = self.predict_trial(self.rows.load_changes(&increments));
        (trial.amplitudes, trial.iteration_limit) = (amplitudes, self.iterations);
        while self.iterate(&mut trial, &mut position, asking) {
            let values = self.retained_values(&trial);
            let extrapolate = |(now, before): (&f64, &f64)| now + EXTRAPOLATION * (now - before);
            let extrapolated: Vec<f64> = values.iter().zip(&self.current.values).map(extrapolate).collect();
            let Some(nonlinear) = self.recheck_dormant(&values, Some(&extrapolated)) else { break };
            if !nonlinear.is_empty() {
                self.activate(&nonlinear, &mut trial, &values);
            } else if !self.break_overstressed(&trial, undo_log) {
                position.reached = Reached::Balanced;
                self.commit(&trial, values, &mut undo_log.states);
                break;
            } else {
                trial.iteration_limit = position.iterations + self.iterations;
            }
        }
        position
    }

    /// Breaks the springs that are most beyond their strength; `false` where none is.
    fn break_overstressed(&mut self, trial: &Trial, undo_log: &mut UndoLog) -> bool {
        let parts = &self.parts;
        let nonlinear = self.active_set.parts.iter().filter(|index| !parts[**index].linear);
        let breaking = weakest(nonlinear.map(|&index| (index, parts[index].overstress(&self.model))));
        if breaking.is_empty() {
            return false;
        }
        let (amplitudes, forces) = (trial.amplitudes.clone(), self.current.forces.clone());
        let mut equilibrium = Equilibrium { amplitudes, forces, ..Equilibrium::default() };
        self.active_set.rows.iter().zip(&trial.forces).for_each(|(&row, force)| equilibrium.forces[row] = *force);
        undo_log.breaks.push(equilibrium);
        for &index in &breaking {
            undo_log.states.push((index, self.parts[index].committed));
            self.parts[index].break_spring();
        }
        self.current.broken.extend(&breaking);
        true
    }

    /// Makes the trial the current equilibrium, and commits the states of the retained parts; `states` gets those before.
    fn commit(&mut self, trial: &Trial, values: Vec<f64>, states: &mut Vec<(usize, Committed)>) {
        self.current.amplitudes.clone_from(&trial.amplitudes);
        self.current.values = values;
        for (&row, force) in self.active_set.rows.iter().zip(&trial.forces) {
            self.current.forces[row] = *force;
        }
        self.position_count += 1;
        for &index in &self.retained {
            let part = &mut self.parts[index];
            if !part.linear {
                self.last_nonlinear[index] = self.position_count;
            }
            states.extend(part.commit().map(|state| (index, state)));
        }
    }
}
