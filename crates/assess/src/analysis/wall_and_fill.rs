//! The two strips of a bridge with spandrel walls, and their loads by their widths.

use super::parallel::Retold;
use super::state::{self, Change};
use super::{AnalysisError, collapse};
use bridge::{Bridge, Strip};
use mechanics::blocks::ModelError;
use mechanics::kept;
use mechanics::watch::{Progress, Watch};
use outcome::collapse::{Collapse, Combination, Component, Status};
use outcome::note::{self, Note};
use outcome::warning;

/// Analyses the strip between the walls, then that of the walls, and adds up what they carry by their widths: the
/// result of the strip between the walls, with the other and the sum beside it. A block that brings a load onto the fill is
/// held sideways and would hold a wall too, so the bricks of the walls are loaded themselves. A kept state starts with the number of
/// the strip that was at work; on resuming the first strip is run again, to the same bits.
pub(super) fn both(bridge: &Bridge, resume: Option<&[u8]>, watch: &mut dyn Watch) -> Result<Collapse, AnalysisError> {
    let wall = bridge.spandrel_wall.as_ref().ok_or(structure::discretise::DiscretiseError::NoWall)?;
    let kept = match resume.map(kept::split::<usize>).transpose()? {
        None => [None, None],
        Some((0, state)) => [Some(state), None],
        Some((1, state)) => [None, Some(state)],
        Some(_) => return Err(ModelError::ForeignState.into()),
    };
    let mut found = strip(bridge, Strip::Fill, kept[0], watch)?;
    if found.status == Status::Cancelled {
        return Ok(found);
    }
    let walls = strip(bridge, Strip::Wall, kept[1], watch)?;
    let mut sum = combination(&found, &walls, [bridge.width - wall.thickness, wall.thickness]);
    if bridge.loads.iter().any(|load| load.block.is_some()) {
        sum.assumptions.push(note::Barrel::BricksLoaded.into());
    }
    if let (Some(total), Some(load)) = (sum.headline, walls.carried()) {
        let (share, width_share) = (load * wall.thickness / total, wall.thickness / bridge.width);
        found.warnings.push(warning::Loads::StripsAdded { share, width_share }.into());
    }
    found.combination = Some(sum);
    if walls.status.exit_code() > found.status.exit_code() {
        found.status = walls.status;
    }
    found.wall_strip = Some(Box::new(walls));
    Ok(found)
}

pub(super) fn strip(
    bridge: &Bridge,
    strip: Strip,
    resume: Option<&[u8]>,
    watch: &mut dyn Watch,
) -> Result<Collapse, AnalysisError> {
    let changes = [Change::Strip(strip), Change::LoadsThroughCover];
    let alone = state::with(bridge, if strip == Strip::Wall { &changes } else { &changes[..1] });
    let (number, name) = if strip == Strip::Wall { (1usize, "below the walls") } else { (0, "between the walls") };
    let told = |progress: &Progress| Progress {
        stage: format!("{name}: {}", progress.stage),
        fraction: progress.fraction.map(|share| 0.5 * (share + number as f64)),
        ..progress.clone()
    };
    collapse(&alone, resume, &mut Retold { watch, kept: Some(&|state| kept::join(&number, state)), told })
}

/// Both strips' loads times their widths [m].
fn combination(fill: &Collapse, wall: &Collapse, widths: [f64; 2]) -> Combination {
    let component = |strip, c: &Collapse, width| Component {
        strip,
        status: c.status,
        collapse_load: c.collapse_load,
        last_stable_load: c.last_stable_load,
        headline: c.carried(),
        width,
    };
    let components = vec![component(Strip::Fill, fill, widths[0]), component(Strip::Wall, wall, widths[1])];
    let sum = |load: fn(&Component) -> Option<f64>| components.iter().map(|c| Some(load(c)? * c.width)).sum();
    let mut assumptions = vec![note::Barrel::StripsSideBySide.into(), note::Barrel::StripsUniform.into()];
    let without = components.iter().filter(|c| c.headline.is_none());
    assumptions.extend(without.map(|c| Note::from(note::Barrel::NoSum { strip: c.strip })));
    Combination {
        collapse_load: sum(|c| c.collapse_load),
        last_stable_load: sum(|c| c.last_stable_load),
        headline: sum(|c| c.headline),
        components,
        assumptions,
    }
}
