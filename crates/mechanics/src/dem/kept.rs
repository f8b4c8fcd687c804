//! States that were kept, set up again: what follows from the model is not kept, and what the model does not have is refused.

use super::model::Model;
use super::particles::{Lean, Particles, chunks, number_all};
use super::run::Run;
use super::state::State;
use super::touch::Touch;
use crate::blocks::ModelError;
use crate::ids::BlockId;
use crate::kept;
use crate::plane::Meeting;

impl State {
    /// The state as bytes, from which [`State::from_bytes`] makes it again to the bit.
    #[must_use]
    pub fn bytes(&self) -> Vec<u8> {
        kept::write(0, self)
    }

    /// A state of this model.
    ///
    /// # Errors
    /// Bytes of another model or format, or damaged ones.
    pub fn from_bytes(model: &Model, bytes: &[u8]) -> Result<State, ModelError> {
        let mut state: State = kept::read(0, bytes)?;
        state.set_up(model).then_some(state).ok_or(ModelError::ForeignState)
    }

    /// Sets up what follows from the model; false where the state is of another one.
    fn set_up(&mut self, model: &Model) -> bool {
        let lists = [self.poses.len(), self.velocities.len(), self.contact_forces.len(), self.previous_forces.len()];
        lists == [model.len(); 4] && self.touches.iter().all(|t| t.is_of(model)) && self.particles.set_up(model)
    }
}

impl Run {
    /// The run that bytes hold.
    ///
    /// # Errors
    /// Bytes that are damaged, or were not kept for what `belongs` stands for.
    pub(super) fn from_bytes(model: &Model, belongs: u64, bytes: &[u8]) -> Result<Run, ModelError> {
        let mut run: Run = kept::read(belongs, bytes)?;
        let stable = run.stable.as_mut().is_none_or(|state| state.set_up(model));
        let fits = stable && run.state.set_up(model) && run.stage.start.len() == model.len();
        fits.then_some(run).ok_or(ModelError::ForeignState)
    }
}

impl Touch {
    /// Whether the model has its blocks, and they its edges and corners.
    fn is_of(&self, model: &Model) -> bool {
        let (a, b) = self.ids();
        let (of_a, of_b, count) = match self.meeting {
            Meeting::Corner { first, second } => (first, second, 1),
            Meeting::Face { flipped: false, reference, incident } => (reference, incident, 2),
            Meeting::Face { flipped: true, reference, incident } => (incident, reference, 2),
        };
        a < b && self.count == count && has_edge(model, a, of_a) && has_edge(model, b, of_b)
    }
}

fn has_edge(model: &Model, block: u32, edge: u32) -> bool {
    (block as usize) < model.len() && (edge as usize) < model.cores[BlockId(block)].len()
}

impl Particles {
    /// Sets contacts up again; false where particles or contacts are not those of the model.
    fn set_up(&mut self, model: &Model) -> bool {
        let count = self.discs.len();
        let stretches = chunks(count);
        let stretches = stretches.iter().map(|chunk| (chunk.first, chunk.count));
        if count != model.particles.len()
            || !(self.previous.is_empty() || self.previous.len() == count)
            || !stretches.eq(self.chunks.iter().map(|chunk| (chunk.first, chunk.count)))
        {
            return false;
        }
        for chunk in &mut self.chunks {
            for contact in &mut chunk.contacts {
                let (one, other) = (u32::from(contact.one), contact.other());
                let i = chunk.first + one;
                if one >= chunk.count || other <= i as usize || other >= count {
                    return false;
                }
                let pair = (i, other as u32);
                *contact = model.particles.contact(&self.discs, &model.laws, pair, contact.one, contact.shear);
            }
            let known = |lean: &Lean| lean.local < chunk.count && has_edge(model, lean.block, lean.edge);
            if !chunk.leans.iter().all(known) {
                return false;
            }
        }
        number_all(&mut self.chunks);
        true
    }
}

#[cfg(test)]
mod tests {
    use super::super::settings::{Damping, Settings};
    use super::super::step::{Workspace, begin, step};
    use super::*;
    use crate::blocks::{Block, BlockModel, ContactLaw, Held, LawTable, Loading, Particle, Stiffness};
    use crate::contact::ContactLength;
    use crate::ids::GroupId;
    use crate::plane::{Polygon, vec2};

    /// A block on another, and two particles side by side on top, after a step.
    fn stepped() -> (Model, State) {
        let block = |low: f64, held| {
            let corners = [(0.0, low), (1.0, low), (1.0, low + 1.0), (0.0, low + 1.0)].map(|(x, y)| vec2(x, y));
            let outline = Polygon::new(corners.to_vec()).unwrap();
            Block { outline, rounding: 0.02, density: 2000.0, group: GroupId(0), held }
        };
        let particle = |x| Particle { centre: vec2(x, 2.1), radius: 0.1, density: 2000.0, group: GroupId(0) };
        let law = ContactLaw {
            normal: Stiffness::Given(1e9),
            shear: Stiffness::Given(1e9),
            friction: 0.5,
            cohesion: 0.0,
            tension: 0.0,
            crushing: f64::INFINITY,
            fixed_length: None,
            least_length: 1e-3,
        };
        let model = BlockModel {
            blocks: [block(0.0, Held::FIXED), block(1.0, Held::FREE)].into_iter().collect(),
            particles: [particle(0.3), particle(0.5)].into_iter().collect(),
            groups: ["stone".to_owned()].into_iter().collect(),
            laws: LawTable::uniform(1, law),
            gravity: vec2(0.0, -9.81),
        };
        let settings = Settings {
            damping: Damping::Local(0.7),
            contact_length: ContactLength::Updated,
            tolerance: 1e-6,
            step_limit: 1000,
            time_step_factor: 0.1,
            scaled_inertia: false,
        };
        let model = Model::new(&model, &Loading::default()).unwrap();
        let mut state = begin(&model, &settings);
        step(&model, &mut state, &mut Workspace::default(), &settings);
        (model, state)
    }

    /// Whole bytes of a state that names what is not there are refused, and nothing is looked up by them.
    #[test]
    fn what_the_model_does_not_have_is_refused() {
        let (model, state) = stepped();
        let taken = |state: &State| State::from_bytes(&model, &state.bytes());
        assert_eq!(taken(&state).map(|same| same.bytes()), Ok(state.bytes()));
        let changes: [&dyn Fn(&mut State); 9] = [
            &|s| s.velocities.push([0.0; 3]),
            &|s| s.touches[0].two = 9,
            &|s| s.touches[0].count = 3,
            &|s| s.touches[0].meeting = Meeting::Corner { first: 9, second: 0 },
            &|s| s.particles.discs.truncate(1),
            &|s| s.particles.chunks[0].count = u32::MAX,
            &|s| s.particles.chunks[0].contacts[0].one = 7,
            &|s| s.particles.chunks[0].leans[0].edge = 99,
            &|s| s.particles.chunks.clear(),
        ];
        for (k, change) in changes.iter().enumerate() {
            let mut other = state.clone();
            change(&mut other);
            assert_eq!(taken(&other).map(|_| ()), Err(ModelError::ForeignState), "change {k}");
        }
    }
}
