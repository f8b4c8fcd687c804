//! The searches that a file asks for, one after the other over one log, and what the data can tell where the best one ended.

use bridge::update::{self, Plan};
use calibrate::posterior::{self, Likelihood, ModelError};
use calibrate::search::sweep::{Sweep, ranking};
use calibrate::search::{gradient, hierarchical, modern, referee};
use calibrate::{Basis, Evaluator, Found, Halt, Linearised, Problem, Serial, Start, surrogate};
use outcome::update::{LinearReport, PaperSearch, PosteriorReport, Search, SearchLine, Update, UpdateStatus};

/// Step of differences as a share of a range, in the modern search and for what the data can tell: joints that open leave answers smooth to a
/// ten-thousandth of a peak, which a step of the usual ten-thousandth would take for a derivative.
pub(super) const STEP: f64 = 5e-3;

/// Points that a surrogate is fitted to, and points that it is judged by.
const SURROGATE: [usize; 2] = [150, 30];

/// The searches of a plan, and the update that they are told in, which is completed until one of them says otherwise.
pub(super) struct Searches<'a> {
    pub plan: &'a Plan,
    pub basis: &'a Basis,
    pub clock: &'a dyn Fn() -> f64,
    pub found: &'a mut Update,
}

/// How a search ended.
enum End {
    Well(String),
    Stopped,
    Failed(String),
}

impl Searches<'_> {
    /// Makes them, until one is stopped. The answer is the one that ended with the least norm of a full passage.
    pub(super) fn make(&mut self, evaluator: &mut Evaluator) {
        let (plan, basis) = (self.plan, self.basis);
        let wants = |search| [search, update::Search::All].contains(&plan.search);
        if wants(update::Search::Hierarchical) {
            self.papers(evaluator);
        }
        if wants(update::Search::Modern) {
            let settings = modern::Settings { starts: plan.starts as usize, seed: plan.seed, step: STEP };
            self.one(Search::Modern, "", evaluator, |_, evaluator| {
                let modern::Outcome { status, found, .. } = modern::search(evaluator, basis, &settings);
                ended(modern::End { status, found })
            });
        }
        if wants(update::Search::Referee) {
            self.one(Search::Referee, "", evaluator, |_, evaluator| {
                ended(referee::search(evaluator, basis, plan.seed, referee::GENERATIONS))
            });
        }
        if wants(update::Search::Gradient) {
            for &(from, start) in gradient_starts(plan.start) {
                self.one(Search::Gradient, from, evaluator, |_, evaluator| {
                    ended(gradient::search(evaluator, basis, start, 100))
                });
            }
        }
        let lines = &self.found.searches;
        let norm = |k: &usize| lines[*k].found.as_ref().map(|found| found.norm).filter(|norm| norm.is_finite());
        let ended = (0..lines.len()).filter_map(|k| norm(&k).map(|norm| (k, norm)));
        self.found.answer = ended.reduce(|best, next| if next.1 < best.1 { next } else { best }).map(|(k, _)| k);
    }

    /// The paper's search by every reading and from every start that is asked for.
    fn papers(&mut self, evaluator: &mut Evaluator) {
        let (plan, basis) = (self.plan, self.basis);
        let starts: &[Start] = match plan.start {
            update::Start::Stated => &[Start::Stated],
            update::Start::Bounds => &[Start::LowerBounds, Start::UpperBounds],
            update::Start::All => &[Start::Means, Start::LowerBounds, Start::UpperBounds],
            update::Start::Means => &[Start::Means],
        };
        let variants: &[hierarchical::Variant] = match plan.variant {
            update::Variant::Printed => &[hierarchical::Variant::Printed],
            update::Variant::AsPractised => &[hierarchical::Variant::AsPractised],
            update::Variant::Both => &[hierarchical::Variant::Printed, hierarchical::Variant::AsPractised],
        };
        for &variant in variants {
            for &start in starts {
                let settings = hierarchical::Settings {
                    variant,
                    start,
                    points: plan.points as usize,
                    passes: plan.passes as usize,
                    ..hierarchical::Settings::default()
                };
                let words = format!("{}, from {}", variant.word(), start.word());
                self.one(Search::Hierarchical, &words, evaluator, |update, evaluator| {
                    let outcome = hierarchical::search(evaluator, basis, &settings);
                    let name = |k: &usize| evaluator.problem.parameters()[*k].name.clone();
                    let end = match &outcome.status {
                        hierarchical::Status::Resolved => End::Well("every parameter resolved".to_owned()),
                        hierarchical::Status::Unresolved(open) => {
                            let open: Vec<String> = open.iter().map(name).collect();
                            End::Well(format!("not resolved: {}", open.join(", ")))
                        }
                        hierarchical::Status::BothAtBounds(pair) => {
                            End::Well(format!("{} and {} both on bounds", name(&pair[0]), name(&pair[1])))
                        }
                        hierarchical::Status::Stopped => End::Stopped,
                        hierarchical::Status::Failed(failure) => End::Failed(failure.message.clone()),
                    };
                    let found = outcome.found.clone();
                    update.paper.push(PaperSearch { variant, start, outcome });
                    (end, found)
                });
            }
        }
    }

    /// One search with its line in the table.
    fn one(
        &mut self,
        search: Search,
        variant: &str,
        evaluator: &mut Evaluator,
        run: impl FnOnce(&mut Update, &mut Evaluator) -> (End, Option<Found>),
    ) {
        if self.found.status == UpdateStatus::Cancelled {
            return;
        }
        let (begun, before) = ((self.clock)(), evaluator.computed);
        let (end, found) = run(self.found, evaluator);
        let status = match end {
            End::Well(words) => words,
            End::Stopped => {
                self.found.status = UpdateStatus::Cancelled;
                "stopped".to_owned()
            }
            End::Failed(message) => {
                self.found.status = UpdateStatus::NotConverged;
                self.found.reason.get_or_insert_with(|| format!("{} search: {message}", search.word()));
                format!("failed: {message}")
            }
        };
        self.found.searches.push(SearchLine {
            search,
            variant: variant.to_owned(),
            status,
            found,
            computed: evaluator.computed - before,
            seconds: (self.clock)() - begun,
        });
    }
}

/// Where the gradient search begins: at the file's values, and where the published search begins elsewhere, there too.
fn gradient_starts(plan: update::Start) -> &'static [(&'static str, Start)] {
    const STARTS: &[(&str, Start)] = &[
        ("from the file's values", Start::Stated),
        ("from lower-bounds", Start::LowerBounds),
        ("from upper-bounds", Start::UpperBounds),
    ];
    match plan {
        update::Start::Stated | update::Start::Means => &STARTS[..1],
        update::Start::Bounds | update::Start::All => STARTS,
    }
}

fn ended(search: modern::End) -> (End, Option<Found>) {
    let end = match search.status {
        modern::Status::Converged => End::Well("converged".to_owned()),
        modern::Status::NotConverged(words) => End::Well(format!("not converged: {words}")),
        modern::Status::Stopped => End::Stopped,
        modern::Status::Failed(failure) => End::Failed(failure.message),
    };
    (end, search.found)
}

/// Common gain and model error as the file asks for them.
pub(super) fn likelihood(plan: &Plan) -> Likelihood {
    let model_error = if plan.model_error > 0.0 { ModelError::Sought(plan.model_error) } else { ModelError::None };
    Likelihood { model_error, common_gain: plan.common_gain_deviation, ..Likelihood::default() }
}

/// Points of a sweep of the straight line.
const LINE_POINTS: usize = 11;

/// What the records leave open with the model as a straight line about the answer; `problem` has the noise to take.
pub(super) fn linearised(
    plan: &Plan,
    evaluator: &mut Evaluator,
    basis: &Basis,
    point: &[f64],
    problem: &Problem,
) -> Result<LinearReport, Halt> {
    let line = Linearised::at(evaluator, basis, point, STEP)?;
    let sweeps = line.sweeps(evaluator.problem, &basis.held, &basis.start, LINE_POINTS);
    let ranking = ranking(&sweeps, Sweep::range);
    Ok(LinearReport { left: line.left(problem, &likelihood(plan), plan.seed), sweeps, ranking })
}

/// The posterior, sampled on a polynomial whose error is checked, stated and joined to the uncertainties of `noise`.
pub(super) fn posterior(
    plan: &Plan,
    evaluator: &mut Evaluator,
    basis: &Basis,
    noise: &Problem,
    clock: &dyn Fn() -> f64,
) -> Result<Result<PosteriorReport, String>, Halt> {
    let begun = clock();
    let polynomial = surrogate::build(evaluator, basis, SURROGATE, plan.seed)?;
    let problem = polynomial.widen(noise);
    let settings = posterior::Settings {
        likelihood: likelihood(plan),
        effective_samples: plan.samples as f64,
        seed: plan.seed,
        ..posterior::Settings::default()
    };
    let mut quick = Evaluator::without_log(&problem, &polynomial, &Serial, &mut *evaluator.watch);
    let sampled = posterior::sample(&mut quick, basis, &settings);
    if sampled.as_ref().is_ok_and(|posterior| posterior.status == posterior::Status::Stopped) {
        return Err(Halt::Stopped);
    }
    let words = |findings: Vec<calibrate::Flaw>| {
        findings.iter().map(|f| format!("{}: {}; {}", f.place, f.message, f.help)).collect::<Vec<_>>().join("; ")
    };
    Ok(sampled.map_err(words).map(|posterior| PosteriorReport {
        posterior,
        surrogate: polynomial.words(),
        seconds: clock() - begun,
    }))
}
