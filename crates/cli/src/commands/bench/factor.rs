//! `extrados bench factor`: the elastic stiffness of a mesh, assembled, factorised and solved with.

use super::repeated::timed;
use crate::args::Bench;
use crate::report::Report;
use crate::status::Status;
use extrados::Refusal;
use mechanics::fem::{Element, FactorError, Pattern, State, Workspace};
use verification::footing::{Footing, Ground, footing};

/// Elements along the ground where `--count` does not say: 99,793 degrees of freedom.
const COLUMNS: u32 = 316;

/// Seconds of one repeat: for the pattern, to analyse, to assemble, to factorise, to solve.
type Seconds = [f64; 5];

/// Repeats all of it; each part's least time.
pub(super) fn run(arguments: &Bench) -> Result<Report, Refusal> {
    let columns = arguments.count.unwrap_or(COLUMNS) as usize;
    let refused = |error: String| Refusal::new("F108", error, "ask for fewer elements");
    let ground = footing(columns, Ground::Elastic, Element::Q4).map_err(|error| refused(error.to_string()))?;
    let (mut all, mut entries) = (Vec::new(), [0; 2]);
    for _ in 0..arguments.repeats {
        let (seconds, found) = repeat(&ground).map_err(|error| refused(error.to_string()))?;
        all.push(seconds);
        entries = found;
    }
    let least = |part: &dyn Fn(&Seconds) -> f64| all.iter().map(part).fold(f64::INFINITY, f64::min);
    let [pattern, analyse, assembly, factor, solve] = [0, 1, 2, 3, 4].map(|part| least(&|seconds| seconds[part]));
    let whole = least(&|[_, analyse, _, factor, solve]| analyse + factor + solve);
    let equations = ground.model.equations();
    Ok(Report::new(Status::Completed)
        .with("name", "factor")
        .with("size", columns * columns.div_ceil(2))
        .with("repeats", arguments.repeats)
        .with("degrees_of_freedom", equations)
        .with("seconds_pattern", pattern)
        .with("seconds_assembly", assembly)
        .with("seconds_analyse", analyse)
        .with("seconds_factor", factor)
        .with("seconds_solve", solve)
        .with("seconds", whole)
        .with("stiffness_entries", entries[0])
        .with("factor_entries", entries[1])
        .saying(format!(
            "factor: {whole:.3} s in all: {analyse:.3} s analyse + {factor:.3} s factor + {solve:.3} s solve, {equations} degrees of \
             freedom, one core\npattern {pattern:.3} s once; assembly into it {assembly:.3} s; {} entries of the stiffness, {} of its \
             factor; least of {} repeats\n",
            entries[0], entries[1], arguments.repeats,
        )))
}

/// Times, and the entries of the stiffness and of its factor.
fn repeat(ground: &Footing) -> Result<(Seconds, [usize; 2]), FactorError> {
    let model = &ground.model;
    let (pattern, of_pattern) = timed(|| Pattern::new(model));
    let (work, analyse) = timed(|| Workspace::with_pattern(model, pattern));
    let (mut work, state) = (work?, State::new(model));
    let (assembled, assembly) = timed(|| work.stiffness(model, &state));
    assembled?;
    let (factorised, factor) = timed(|| work.factorise());
    factorised?;
    let right = vec![1.0; model.equations()];
    let (solved, solve) = timed(|| work.solve(&right, 1e-6));
    solved?;
    Ok(([of_pattern, analyse, assembly, factor, solve], [work.tangent_entries(), work.factor_entries()]))
}
