//! The norm over two parameters in bands, the path that the search took, and the least point (railway paper, Figs. 7 to 9).

use super::bands::Grid;
use super::style::axis;
use super::words::{fitting, search_words, second_line, value_words};
use crate::chart::{Axes, Entry, Mark, Panel, key};
use crate::colour::dark_for_much;
use crate::elevation::INK;
use crate::sheet::place::Room;
use crate::sheet::{Anchor, Area, HAIR, MARGIN, Pen, Sheet, Style, WIDTH};
use crate::ticks::Ticks;
use crate::words::{four_digits, three_digits};
use outcome::calibrate::search::hierarchical::Stage;
use outcome::calibrate::search::surface::{Case, Surface};
use outcome::update::{PaperSearch, Update};

const HEIGHT: f64 = 400.0;
/// Most lines between bands.
const MOST: usize = 12;
const PATH: &str = "#b00020";
/// A line at so much more than the least norm shows how long a trough is.
const NEAR: f64 = 0.05;
const NEAR_DASHES: &str = "3 2";
/// A least point, four arms long.
const ARM: f64 = 8.0;

/// One surface of one pass.
pub(super) fn surface(update: &Update, paper: &PaperSearch, number: usize, place: usize) -> Option<String> {
    let pass = paper.outcome.passes.get(number)?;
    let stage = pass.stages.get(place)?;
    let surface = &stage.surface;
    let known = || surface.norms.iter().flatten().copied().filter(|norm| norm.is_finite());
    let (low, high) = (known().reduce(f64::min)?, known().reduce(f64::max)?);
    let levels = levels(low, high);

    let names = surface.parameters.map(|k| {
        let parameter = &update.problem.parameters()[k];
        fitting(&parameter.name, &parameter.unit, HEIGHT)
    });
    let what = format!(
        "Norm over two parameters, pass {}, surface {}; {}",
        number + 1,
        place + 1,
        search_words(update, paper)
    );
    let (mut sheet, top) =
        Sheet::titled(&format!("surface-{}-{}", number + 1, place + 1), &update.bridge, &second_line(update, &what));
    let travelled = path(paper, number, place, surface);
    let mut panel = plane(update, surface, &names)?;
    panel.clip("surface", "bands");
    panel.add(|sheet, axes| bands(sheet, surface, axes, &levels));
    panel.close();
    panel.add(|sheet, axes| sheet.rectangle(axes.area, Pen::line(INK, 0.9)));
    panel.add(|sheet, axes| evaluated(sheet, surface, axes));
    panel.add(|sheet, axes| walk(sheet, axes, &travelled));
    panel.add(|sheet, axes| least(sheet, update, surface, axes));
    let below = panel.whole(&mut sheet, [top, HEIGHT], panel.y.widest(), true);

    let bottom = legend(&mut sheet, below, &levels, [low, high]);
    let near = format!("{} % above the least norm", three_digits(100.0 * NEAR));
    let entries = [
        Entry::mark(Mark::Full, "#555555", "point of the grid"),
        Entry::line((INK, NEAR_DASHES), near).when(known().any(|norm| norm > (1.0 + NEAR) * low)),
        Entry::line((PATH, ""), "path of the search so far").marked(Mark::Hollow, PATH).when(travelled.len() > 1),
    ];
    let bottom = key(&mut sheet, bottom, &entries);
    Some(sheet.end(bottom, &words(update, stage, travelled.len() > 1)))
}

/// Round levels between two norms. Where the norm grows manifold they stand closer below than above: troughs are what is looked
/// for, and a range that is too wide on one side must not hide them.
fn levels(low: f64, high: f64) -> Vec<f64> {
    let between = |level: &f64| *level > low && *level < high;
    if high < 3.0 * low {
        return Ticks::over(low, high, MOST - 2).values.into_iter().filter(between).collect();
    }
    let series: [&[f64]; 4] = [
        &[1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0],
        &[1.0, 1.5, 2.0, 3.0, 5.0, 7.0],
        &[1.0, 2.0, 5.0],
        &[1.0],
    ];
    // Below a millionth of the largest norm nothing is told apart.
    let least = low.max(1e-6 * high).max(f64::MIN_POSITIVE);
    let powers = least.log10().floor() as i32..=high.log10().floor() as i32;
    let made = series.iter().map(|leads| {
        let all = powers.clone().flat_map(|power| leads.iter().map(move |lead| lead * 10f64.powi(power)));
        all.filter(between).collect::<Vec<f64>>()
    });
    made.reduce(|finer, coarser| if finer.len() <= MOST { finer } else { coarser }).unwrap_or_default()
}

/// The plane of both ranges; none where a parameter has fewer than two values.
fn plane<'a>(update: &Update, surface: &Surface, names: &'a [String; 2]) -> Option<Panel<'a>> {
    let side = |side: usize, count: usize| {
        let values = &surface.values[side];
        let (first, last) = (*values.first()?, *values.last()?);
        let parameter = &update.problem.parameters()[surface.parameters[side]];
        (last > first).then(|| axis(parameter, &names[side], [first, last], count))
    };
    Some(Panel::new(side(0, 8)?, side(1, 7)?))
}

/// Norm at a place of the grid.
fn norm(surface: &Surface, i: usize, j: usize) -> Option<f64> {
    surface.norms.get(i * surface.values[1].len() + j).copied().flatten()
}

fn bands(sheet: &mut Sheet, surface: &Surface, axes: &Axes, levels: &[f64]) {
    let (first, last) = (surface.values[0][0], surface.values[1][0]);
    let x: Vec<f64> = surface.values[0].iter().map(|value| axes.spot([*value, last])[0]).collect();
    let y: Vec<f64> = surface.values[1].iter().map(|value| axes.spot([first, *value])[1]).collect();
    let height = |i: usize, j: usize| norm(surface, i, j);
    let grid = Grid { x: &x, y: &y, height: &height };
    sheet.rectangle(axes.area, Pen::shape("#ffffff", "none", 0.0));
    for (band, polygons) in grid.bands(levels).iter().enumerate() {
        let colour = colour(band, levels.len());
        for polygon in polygons {
            // A hair of the same colour closes the seams between neighbours.
            sheet.polygon(polygon, Pen::shape(&colour, &colour, 0.4));
        }
    }
    sheet.open_drawn("levels", Pen::line("#ffffff", HAIR));
    for level in levels {
        sheet.strokes(&grid.line(*level), 0.7);
    }
    sheet.close();
    sheet.open_drawn("near", Pen::line(INK, HAIR).dashed(NEAR_DASHES));
    sheet.strokes(&grid.line((1.0 + NEAR) * surface.norm()), 0.9);
    sheet.close();
}

fn colour(band: usize, levels: usize) -> String {
    dark_for_much((band as f64 + 0.5) / (levels as f64 + 1.0))
}

/// Where the model was asked, and where it found no answer.
fn evaluated(sheet: &mut Sheet, surface: &Surface, axes: &Axes) {
    for (i, x) in surface.values[0].iter().enumerate() {
        for (j, y) in surface.values[1].iter().enumerate() {
            let at = axes.spot([*x, *y]);
            if norm(surface, i, j).is_some() {
                sheet.circle(at, 1.5, Pen::shape("#555555", "#ffffff", 0.4).class("asked"));
            } else {
                for side in [-3.5, 3.5] {
                    let ends = [[at[0] - 3.5, at[1] - side], [at[0] + 3.5, at[1] + side]];
                    sheet.line(ends[0], ends[1], Pen::line(PATH, 1.4).class("failed"));
                }
            }
        }
    }
}

/// The models on the way to this surface's least point, in its plane; each once where it stayed.
fn path(paper: &PaperSearch, number: usize, place: usize, surface: &Surface) -> Vec<[f64; 2]> {
    // The start; of every pass a step for the lesser parameters, for each surface and for each last sweep.
    let before = paper.outcome.passes.iter().take(number);
    let steps = 1 + before.map(|pass| 1 + pass.stages.len() + pass.last.len()).sum::<usize>() + 1 + place + 1;
    let points = paper.outcome.path.iter().take(steps);
    let mut plane: Vec<[f64; 2]> = points.map(|step| surface.parameters.map(|k| step.point[k])).collect();
    plane.dedup();
    plane
}

fn walk(sheet: &mut Sheet, axes: &Axes, travelled: &[[f64; 2]]) {
    let spots = axes.spots(travelled);
    if spots.len() < 2 {
        return;
    }
    sheet.polyline(&spots, Pen::line("#ffffff", 4.2));
    for pair in spots.windows(2) {
        sheet.arrow(pair[0], pair[1], Pen::line(PATH, 1.8).class("path"));
    }
    for at in &spots[..spots.len() - 1] {
        Mark::Hollow.draw(sheet, *at, PATH);
    }
    // Words on the path hide more than words on bands do.
    for _ in 0..4 {
        sheet.avoid_line(&spots);
    }
    let room = Room { area: axes.area.grown(-5.0), towards: [0.0, -1.0], clear: 9.0 };
    sheet.label(spots[0], "start", Style::on_drawing(), room);
}

/// The least point with its words.
fn least(sheet: &mut Sheet, update: &Update, surface: &Surface, axes: &Axes) {
    let values = [0, 1].map(|side| surface.values[side][surface.minima[side].place]);
    let at = axes.spot(values);
    for (colour, width) in [("#ffffff", 5.0), (INK, 2.2)] {
        sheet.line([at[0] - ARM, at[1]], [at[0] + ARM, at[1]], Pen::line(colour, width));
        sheet.line([at[0], at[1] - ARM], [at[0], at[1] + ARM], Pen::line(colour, width));
    }
    sheet.avoid(Area::about(at, ARM));
    let unit = |side: usize| update.problem.parameters()[surface.parameters[side]].unit.as_str();
    let text = format!(
        "least norm {} at {}, {}",
        three_digits(surface.norm()),
        value_words(values[0], unit(0)),
        value_words(values[1], unit(1))
    );
    let inwards = |k: usize, low: f64, high: f64| if at[k] > 0.5 * (low + high) { -0.7 } else { 0.7 };
    let area = axes.area;
    let towards = [inwards(0, area.left, area.right), inwards(1, area.top, area.bottom)];
    sheet.label(at, &text, Style::on_drawing(), Room { area: area.grown(-5.0), towards, clear: 13.0 });
}

/// The bands in a row, a value between each two; returns the y below.
fn legend(sheet: &mut Sheet, top: f64, levels: &[f64], [low, high]: [f64; 2]) -> f64 {
    let style = Style::small();
    let text = format!("norm [-], {} to {}", three_digits(low), three_digits(high));
    let y = sheet.paragraph(MARGIN, top, WIDTH - 2.0 * MARGIN, &text, style);
    let (left, wide) = (MARGIN + 10.0, (560.0 / (levels.len() + 1) as f64).min(70.0));
    let (upper, lower) = (y + 5.0, y + 19.0);
    sheet.open("legend");
    for band in 0..=levels.len() {
        let at = left + wide * band as f64;
        let colour = colour(band, levels.len());
        sheet.rectangle(Area { left: at, right: at + wide, top: upper, bottom: lower }, Pen::shape(&colour, INK, HAIR));
    }
    for (k, level) in levels.iter().enumerate() {
        let at = left + wide * (k as f64 + 1.0);
        sheet.line([at, lower], [at, lower + 4.0], Pen::line(INK, 0.9));
        sheet.text([at, lower + 17.0], &four_digits(*level), style.anchored(Anchor::Middle));
    }
    sheet.close();
    lower + 24.0
}

/// What followed from the surface.
fn words(update: &Update, stage: &Stage, moved: bool) -> String {
    let parameters = update.problem.parameters();
    let name = |k: &usize| parameters[*k].name.as_str();
    let surface = &stage.surface;
    let mut words = match surface.case {
        Case::Interior => "The least point lies inside both ranges.".to_owned(),
        Case::OneAtBound => "The least point lies on a bound of one range.".to_owned(),
        Case::BothAtBound => "The least point lies on a bound of both ranges.".to_owned(),
    };
    for side in 0..2 {
        if !surface.minima[side].decided {
            words += &format!(" No decided trough of {}.", name(&surface.parameters[side]));
        }
    }
    let mut say = |which: &[usize], what: &str| {
        if !which.is_empty() {
            words += &format!(" {what}: {}.", which.iter().map(name).collect::<Vec<_>>().join("; "));
        }
    };
    say(&stage.frozen, "Frozen here");
    say(stage.carried.as_slice(), "Carried on");
    say(stage.set_aside.as_slice(), "Set aside");
    let others = (0..parameters.len()).filter(|k| !surface.parameters.contains(k));
    let others: Vec<String> =
        others.map(|k| format!("{} {}", name(&k), value_words(surface.model[k], &parameters[k].unit))).collect();
    if !others.is_empty() {
        let before = if moved { "; earlier on the path they stood elsewhere" } else { "" };
        words += &format!(" All others stand at: {}{before}.", others.join("; "));
    }
    if surface.norms.iter().any(Option::is_none) {
        words += " Crosses: the model found no answer.";
    }
    words
}

#[cfg(test)]
mod tests {
    use super::levels;

    #[test]
    fn levels_are_few_round_and_denser_below() {
        assert_eq!(levels(0.19, 0.31), [0.2, 0.22, 0.24, 0.26, 0.28, 0.3].map(|l: f64| (l * 50.0).round() / 50.0));
        let wide = levels(0.112, 3.15);
        assert_eq!(wide.first().map(|level| (level * 100.0).round()), Some(15.0));
        assert!(wide.len() > 5 && wide.windows(2).all(|pair| pair[0] < pair[1]), "{wide:?}");
        for (low, high) in [(0.0, 1.0), (1e-9, 2.0), (0.5, 0.5), (0.0, 0.0), (0.09, 0.7), (1e-3, 1e3)] {
            assert!(levels(low, high).len() <= 13, "{low} {high}");
        }
    }
}
