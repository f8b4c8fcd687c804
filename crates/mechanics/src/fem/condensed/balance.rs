//! Balance in one position: iterations, parts that get hot, pairs that break.

use super::newton::Trial;
use super::parts::Committed;
use super::{Condensed, Place, Position, Reached};
use crate::fem::joint::weakest;

/// How many steps like the last are foreseen for active parts that may begin to move. Without it a passage makes half as many iterations again.
const FORESEEN: f64 = 2.0;

/// What happened on the way to a position.
#[derive(Debug, Default)]
pub(super) struct Track {
    /// What parts remembered before, in the order in which that changed.
    pub before: Vec<(usize, Committed)>,
    /// Balanced places in which something was beyond its strength and broke: other parts are looked at there, too, for they may have to break first.
    pub breaks: Vec<Place>,
}

impl Condensed<'_> {
    /// Balances loads on top of what was there at the start, from the last position, with the active parts. What happens goes to `track`; where there is no
    /// balance, nothing has changed.
    pub(super) fn go(&mut self, to: Vec<f64>, track: &mut Track) -> Position {
        let (known, breaks, whole) = (track.before.len(), track.breaks.len(), self.at.broken.len());
        let position = self.balance(to, track);
        if position.reached != Reached::Balanced {
            self.at.broken.truncate(whole);
            track.breaks.truncate(breaks);
            track.before.drain(known..).rev().for_each(|(part, remembered)| self.parts[part].restore(&remembered));
        }
        position
    }

    /// The same; where there is no balance, what broke stays broken.
    fn balance(&mut self, to: Vec<f64>, track: &mut Track) -> Position {
        let mut position = Position { reached: Reached::NotConverged, iterations: 0, left: f64::INFINITY };
        let foreseen = std::mem::take(&mut self.foreseen);
        self.hot.add(foreseen.into_iter(), &self.parts, &self.rows);
        let more: Vec<f64> = to.iter().zip(&self.at.amplitudes).map(|(to, from)| to - from).collect();
        let mut trial = self.guess(self.rows.load_changes(&more));
        (trial.to, trial.limit) = (to, self.iterations);
        while self.iterate(&mut trial, &mut position) {
            let values = self.values_of_all(&trial);
            let ahead = |(now, before): (&f64, &f64)| now + FORESEEN * (now - before);
            let ahead: Vec<f64> = values.iter().zip(&self.at.values).map(ahead).collect();
            let Some(moving) = self.moving_among_the_cool(&values, Some(&ahead)) else { break };
            if !moving.is_empty() {
                self.heat(&moving, &mut trial, &values);
            } else if !self.lets_go(&trial, track) {
                position.reached = Reached::Balanced;
                self.keep(&trial, values, &mut track.before);
                break;
            } else {
                trial.limit = position.iterations + self.iterations;
            }
        }
        position
    }

    /// Breaks the springs that are most beyond their strength; `false` where none is.
    fn lets_go(&mut self, trial: &Trial, track: &mut Track) -> bool {
        let parts = &self.parts;
        let moving = self.hot.parts.iter().filter(|index| !parts[**index].linear);
        let breaking = weakest(moving.map(|&index| (index, parts[index].overstress(self.model))));
        if breaking.is_empty() {
            return false;
        }
        let mut place = Place { amplitudes: trial.to.clone(), forces: self.at.forces.clone(), ..Place::default() };
        self.hot.rows.iter().zip(&trial.forces).for_each(|(&row, force)| place.forces[row] = *force);
        track.breaks.push(place);
        for &index in &breaking {
            track.before.push((index, self.parts[index].committed()));
            self.parts[index].break_spring();
        }
        self.at.broken.extend(&breaking);
        true
    }

    fn keep(&mut self, trial: &Trial, values: Vec<f64>, before: &mut Vec<(usize, Committed)>) {
        self.at.amplitudes.clone_from(&trial.to);
        self.at.values = values;
        for (&row, force) in self.hot.rows.iter().zip(&trial.forces) {
            self.at.forces[row] = *force;
        }
        self.clock += 1;
        for &index in &self.active {
            let part = &mut self.parts[index];
            if !part.linear {
                self.moved_at[index] = self.clock;
            }
            before.extend(part.commit().map(|remembered| (index, remembered)));
        }
    }
}
