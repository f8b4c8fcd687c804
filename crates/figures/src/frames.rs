//! The way down: a few states of one run side by side.

use crate::discs;
use crate::elevation as draw;
use crate::geometry::{Extent, Turn, View, as_built, largest_displacement, moved, round_down};
use crate::panels::outline;
use crate::sheet::{Area, HAIR, MARGIN, Pen, SMALL, Sheet, Style, WIDTH};
use crate::words;
use outcome::picture::{Motion, Picture};

/// Most panels on a sheet.
const MOST: usize = 6;
/// Gap between panels.
const GAP: f64 = 18.0;
/// Share of the larger dimension of the bridge that displacements are drawn with, at most, where they are exaggerated.
const SHARE: f64 = 0.06;

/// How the states of a run are drawn, all alike.
pub(crate) struct Frames {
    /// Snapshots that fit blocks and particles, in their order.
    pub usable: Vec<usize>,
    /// How many times larger displacements are drawn; particles are never exaggerated.
    pub scale: f64,
    /// What is drawn [m].
    pub extent: Extent,
}

impl Frames {
    /// All states of a run that fit. None without any, and where nothing moves.
    pub(crate) fn of(picture: &Picture) -> Option<Frames> {
        let built = as_built(&picture.shapes)?;
        let fits = |k: &usize| crate::panels::fits(picture, *k);
        let usable: Vec<usize> = (0..picture.snapshots.len()).filter(fits).collect();
        let size = built.size()[0].max(built.size()[1]);
        let motions = |k: usize| &picture.snapshots[k].motions;
        let largest = |k: &usize| largest_displacement(&picture.shapes, motions(*k), Turn::Finite);
        let largest = usable.iter().map(largest).fold(0.0, f64::max);
        if largest <= 1e-9 * size {
            return None;
        }
        let scale = if picture.particles.is_empty() { round_down(SHARE * size / largest).max(1.0) } else { 1.0 };
        let corners = |motions: &[Motion]| -> Vec<_> {
            picture.shapes.iter().zip(motions).flat_map(|(s, &m)| moved(s, m, scale, Turn::Finite)).collect()
        };
        // A block thrown far away does not make the bridge small.
        let extent = usable
            .iter()
            .filter_map(|&k| Extent::of(corners(motions(k))))
            .fold(built, |e, f| e.with(f))
            .within(built.grown(0.6 * size))
            .grown(0.015 * size);
        Some(Frames { usable, scale, extent })
    }

    /// Draws one state, or the bridge as built.
    pub(crate) fn draw(&self, sheet: &mut Sheet, view: &View, picture: &Picture, panel: Option<usize>) {
        let state = panel.map(|k| &picture.snapshots[k]);
        discs::draw(sheet, view, picture, state, |k| discs::band_colour(picture, k).into());
        draw::blocks(sheet, view, &picture.shapes, |k| outline(picture, state, k, self.scale));
    }

    /// Whether displacements are exaggerated, in words.
    pub(crate) fn how(&self) -> String {
        if self.scale > 1.0 { format!("exaggerated {}", words::times(self.scale)) } else { "at true scale".into() }
    }
}

/// The bridge as built, at its last stable load, and in even steps of what came after; displacements exaggerated
/// alike where they would not be seen. A run with particles begins at rest and shows half of the last stable load too.
/// Without a last stable state, even steps of the whole run. None where nothing moves.
pub fn collapse_frames(picture: &Picture) -> Option<String> {
    let run = Frames::of(picture)?;
    let panels = panels(picture, &run.usable);
    let whole = run.extent;
    let (mut sheet, top) = Sheet::titled("collapse", &picture.title, &format!("Collapse, displacements {}", run.how()));
    let [w, h] = whole.size();
    let columns = match panels.len() {
        1 => 1,
        count if h > 1.4 * w => count.min(3),
        _ => 2,
    };
    let wide = (WIDTH - 2.0 * MARGIN - GAP * (columns - 1) as f64) / columns as f64;
    let high = (wide * h / w.max(1e-9)).min(300.0);
    let style = Style::small();
    let words = |panel: Option<usize>| panel.map_or("as built".into(), |k| crate::panels::load(picture, k));
    let texts: Vec<String> = panels
        .iter()
        .enumerate()
        .map(|(n, panel)| format!("({}) {}", char::from(b'a' + (n % 26) as u8), words(*panel)))
        .collect();
    let lines = texts.iter().map(|t| style.wrap(t, wide).len()).max().unwrap_or(1);
    let pitch = high + 1.3 * SMALL * lines as f64 + 14.0;
    for (n, panel) in panels.iter().enumerate() {
        let (row, column) = (n / columns, n % columns);
        let left = MARGIN + column as f64 * (wide + GAP);
        let upper = top + row as f64 * pitch;
        let area = Area { left, right: left + wide, top: upper, bottom: upper + high };
        let view = View::fit(whole, area);
        sheet.open_clipped("panel", &format!("panel-{n}"), area);
        run.draw(&mut sheet, &view, picture, *panel);
        sheet.close();
        sheet.rectangle(area, Pen::line("#9a9a9a", HAIR));
        sheet.paragraph(left, area.bottom + 2.0, wide, &texts[n], style);
    }
    let rows = panels.len().div_ceil(columns);
    let mut y = top + rows as f64 * pitch - 12.0;
    if discs::drawable(picture) {
        y = discs::key(&mut sheet, y + 4.0, picture, true);
        y = sheet.caption(y, BANDS);
    }
    Some(sheet.finish(y))
}

/// What the bands in the fill are.
pub(crate) const BANDS: &str =
    "Each layer of the fill has upright bands one metre wide, as packed: they show how it has moved.";

/// What the panels show: snapshots, or the bridge as built.
fn panels(picture: &Picture, usable: &[usize]) -> Vec<Option<usize>> {
    if picture.particles.is_empty() {
        return std::iter::once(None)
            .chain(choose(usable, picture.last_stable, MOST - 1).into_iter().map(Some))
            .collect();
    }
    let (Some(&first), Some(stable)) = (usable.first(), picture.last_stable) else {
        return choose(usable, picture.last_stable, MOST).into_iter().map(Some).collect();
    };
    let goal = 0.5 * picture.snapshots[stable].load;
    let off = |k: &usize| (picture.snapshots[*k].load - goal).abs();
    let early = usable.iter().copied().filter(|&k| k > first && k < stable).min_by(|a, b| off(a).total_cmp(&off(b)));
    let mut chosen: Vec<usize> = [Some(first).filter(|&k| k < stable), early].into_iter().flatten().collect();
    chosen.extend(choose(usable, Some(stable), MOST - chosen.len()));
    chosen.into_iter().map(Some).collect()
}

/// Which snapshots are drawn: the last stable one, and even steps of what follows.
fn choose(usable: &[usize], last_stable: Option<usize>, most: usize) -> Vec<usize> {
    let (mut chosen, rest): (Vec<usize>, Vec<usize>) = match last_stable.filter(|k| usable.contains(k)) {
        Some(stable) => (vec![stable], usable.iter().copied().filter(|&k| k > stable).collect()),
        None => (Vec::new(), usable.to_vec()),
    };
    let places = most - chosen.len();
    let count = rest.len().min(places);
    // Even steps that end at the last one.
    chosen.extend((1..=count).map(|k| rest[k * rest.len() / count - 1]));
    chosen
}

#[cfg(test)]
mod tests {
    use super::*;
    use outcome::picture::{Disc, Snapshot};

    #[test]
    fn panels_run_from_the_last_stable_state_to_the_end() {
        let usable: Vec<usize> = (0..40).collect();
        assert_eq!(choose(&usable, Some(17), 5), [17, 22, 28, 33, 39]);
        assert_eq!(choose(&usable, None, 5).last(), Some(&39));
        assert_eq!(choose(&usable, None, 5).len(), 5);
        assert_eq!(choose(&[0], Some(0), 5), [0]);
        assert_eq!(choose(&[0, 1], Some(0), 5), [0, 1]);
    }

    #[test]
    fn a_run_with_particles_begins_at_rest_and_shows_an_early_load() {
        let state = |k: usize| Snapshot { load: k as f64, ..Snapshot::default() };
        let disc = Disc { centre: [0.0, 0.0], radius: 1.0, layer: 0 };
        let snapshots = (0..30).map(state).collect();
        let picture = Picture { particles: vec![disc], snapshots, last_stable: Some(20), ..Picture::default() };
        let usable: Vec<usize> = (0..30).collect();
        let found: Vec<usize> = panels(&picture, &usable).into_iter().flatten().collect();
        assert_eq!(found, [0, 10, 20, 23, 26, 29]);
        let falls_at_once = Picture { last_stable: Some(0), ..picture };
        assert_eq!(panels(&falls_at_once, &usable).len(), 6);
    }
}
