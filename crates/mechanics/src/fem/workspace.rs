//! Scratch of a model: pattern, factorisation, and what an iteration tries.

use super::assemble::assemble;
use super::factor::{FactorError, Solver};
use super::gmres::norm;
use super::model::Model;
use super::pattern::Pattern;
use super::settings::Kinematics;
use super::state::State;

/// Scratch; made once for a model and used for all of its states.
pub struct Workspace {
    pub(super) pattern: Pattern,
    pub(super) solver: Solver,
    /// Symmetric part of the tangent: lower triangle, then entries that join held components, then one that nobody reads.
    pub(super) values: Vec<f64>,
    /// The rest of it, where it is not symmetric; empty in models that have symmetric tangents alone.
    pub(super) skew: Vec<f64>,
    /// Whether anything in `skew` differs from zero.
    pub(super) skewed: bool,
    /// Force on modes of elements that is not balanced yet [N/m], all together.
    pub(super) loose: f64,
    /// Internal forces on all components [N/m] at the displacements for which the tangent was computed last.
    pub internal: Vec<f64>,
    /// What the state would be if it were kept.
    pub(super) trial: State,
    /// How often in this attempt the modes of each element found no balance.
    pub(super) misses: Vec<u8>,
    /// Whether `values` are the tangent with which the last kept step ended.
    pub(super) fresh: bool,
}

impl Workspace {
    /// Finds the pattern and orders the equations.
    ///
    /// # Errors
    /// A factor that does not fit into memory.
    pub fn new(model: &Model) -> Result<Workspace, FactorError> {
        Workspace::with_pattern(model, Pattern::new(model))
    }

    /// Orders the equations of a pattern that was found before.
    ///
    /// # Errors
    /// A factor that does not fit into memory.
    pub fn with_pattern(model: &Model, pattern: Pattern) -> Result<Workspace, FactorError> {
        Ok(Workspace {
            solver: Solver::new(&pattern)?,
            values: vec![0.0; pattern.places()],
            skew: if model.symmetric() { Vec::new() } else { vec![0.0; pattern.places()] },
            skewed: false,
            loose: 0.0,
            internal: vec![0.0; model.dofs.equation.len()],
            trial: State::new(model),
            misses: vec![0; model.mesh.quads.len()],
            pattern,
            fresh: false,
        })
    }

    /// Computes the tangent of a state.
    ///
    /// # Errors
    /// An element or a spring that has no answer to the state.
    pub fn stiffness(&mut self, model: &Model, state: &State) -> Result<(), FactorError> {
        self.take(state);
        assemble(model, self, state).ok_or(FactorError::Singular)
    }

    /// Factorises the tangent at hand; tells whether its symmetric part is positive definite.
    ///
    /// # Errors
    /// A tangent without an inverse.
    pub fn factorise(&mut self) -> Result<bool, FactorError> {
        self.solver.factorise(&self.pattern, &self.values)
    }

    /// Solves with the tangent factorised last, for free components; `accuracy` is the residual over the right-hand side that is enough where
    /// the tangent is not symmetric.
    ///
    /// # Errors
    /// A tangent without an inverse or one that is too ill-conditioned, or a factor that does not fit into memory.
    pub fn solve(&mut self, right: &[f64], accuracy: f64) -> Result<Vec<f64>, FactorError> {
        let skew: &[f64] = if self.skewed { &self.skew } else { &[] };
        self.solver.solve(&self.pattern, (&self.values, skew), right, accuracy)
    }

    /// Solves with the symmetric part of the tangent and a share of its diagonal more; `None` where that is not positive definite.
    pub(super) fn solve_damped(&mut self, right: &[f64], share: f64) -> Option<Vec<f64>> {
        let mut values = self.values[..self.pattern.entries()].to_vec();
        for equation in 0..right.len() {
            let diagonal = &mut values[self.pattern.column(equation).start];
            *diagonal += share * diagonal.abs();
        }
        let definite = self.solver.factorise(&self.pattern, &values).ok()?;
        definite.then(|| self.solver.solve(&self.pattern, (&values, &[]), right, 0.0).ok())?
    }

    /// The tangent computed last times a vector of free components.
    pub fn tangent_times(&self, x: &[f64]) -> Vec<f64> {
        let mut out = vec![0.0; x.len()];
        let skew: &[f64] = if self.skewed { &self.skew } else { &[] };
        self.pattern.multiply(&self.values, skew, x, &mut out);
        out
    }

    /// Entries of the tangent's lower triangle.
    pub fn tangent_entries(&self) -> usize {
        self.pattern.entries()
    }

    /// Entries of its factor.
    pub fn factor_entries(&self) -> usize {
        self.solver.values.len()
    }

    /// Starts from a state.
    pub(super) fn take(&mut self, state: &State) {
        self.trial.displacements.copy_from_slice(&state.displacements);
        self.trial.modes.copy_from_slice(&state.modes);
        self.misses.fill(0);
    }

    /// Keeps what was tried: memories are exchanged, not copied.
    pub(super) fn keep(&mut self, state: &mut State, forces: &[f64]) {
        std::mem::swap(&mut self.trial.points, &mut state.points);
        std::mem::swap(&mut self.trial.bonds, &mut state.bonds);
        state.displacements.copy_from_slice(&self.trial.displacements);
        state.modes.copy_from_slice(&self.trial.modes);
        state.forces.copy_from_slice(forces);
        self.fresh = true;
    }

    /// What is out of balance at the free components: loads less internal forces [N/m].
    pub(super) fn unbalanced(&self, model: &Model, forces: &[f64]) -> Vec<f64> {
        let free = model.dofs.free.iter();
        free.map(|component| forces[*component as usize] - self.internal[*component as usize]).collect()
    }

    /// Bound on the out-of-balance force that rounding of displacements and places leaves [N/m]: slender and stiff parts carry little
    /// of what their stiffness times their displacement would be.
    pub(super) fn rounding(&self, model: &Model) -> f64 {
        let places = match model.kinematics {
            Kinematics::Small => 0.0,
            Kinematics::Large => model.size,
        };
        let of = |(equation, component): (usize, &u32)| {
            let moved = self.trial.displacements[*component as usize].abs() + places;
            self.values[self.pattern.column(equation).start] * moved
        };
        let terms: Vec<f64> = model.dofs.free.iter().enumerate().map(of).collect();
        4.0 * f64::EPSILON * norm(&terms)
    }

    /// Size of what is applied: loads on free components, or reactions, whichever are larger [N/m].
    pub(super) fn applied(&self, model: &Model, forces: &[f64]) -> f64 {
        let dofs = &model.dofs;
        let loads = dofs.of_free(forces);
        let held = || (0..dofs.equation.len()).filter(|component| dofs.held(*component));
        // Supports that stay where they are answer the loads; only where they are moved do their reactions load the body.
        if held().all(|component| self.trial.displacements[component] == 0.0) {
            return norm(&loads);
        }
        let reactions: Vec<f64> = held().map(|component| self.internal[component] - forces[component]).collect();
        norm(&loads).max(norm(&reactions))
    }
}

/// Forces [N/m] that the supports exert, by component; zero at free components, and not numbers where an element has no answer.
pub fn reactions(model: &Model, work: &mut Workspace, state: &State) -> Vec<f64> {
    if work.stiffness(model, state).is_err() {
        return vec![f64::NAN; state.forces.len()];
    }
    let dofs = &model.dofs;
    let of = |component: usize| match dofs.held(component) {
        true => work.internal[component] - state.forces[component],
        false => 0.0,
    };
    (0..dofs.equation.len()).map(of).collect()
}
