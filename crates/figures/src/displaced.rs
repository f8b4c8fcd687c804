//! How far particles and blocks moved since they came to rest.

use crate::bar::{Scale, quantile};
use crate::colour::blue_for_much;
use crate::discs;
use crate::elevation::{self as draw, LOAD};
use crate::geometry::{View, centroid};
use crate::near::cells;
use crate::panels::{coloured, fits, load, panel, shown};
use crate::sheet::{MARGIN, Pen, Sheet, THIN, WIDTH};
use crate::words;
use outcome::picture::{Picture, Point, Snapshot};

/// Side of a square of the sheet that gets one arrow.
const GRID: f64 = 27.0;
/// Longest arrow on the sheet.
const LONGEST: f64 = 24.0;
/// The scale of colours ends where this share of particles and blocks moves less.
const SHARE: f64 = 0.98;
/// A collapse is drawn once a particle or block has moved by this many mean particle diameters.
const CLEARLY: f64 = 1.0;

/// Displacement since the first state at rest, at the last stable load and in the collapse: particles and blocks
/// coloured by its size, arrows for its mean over squares of a grid. None without particles or a second state.
pub fn displacement(picture: &Picture) -> Option<String> {
    let stable = shown(picture).filter(|_| discs::drawable(picture) && fits(picture, 0))?;
    let rest = picture.snapshots.first()?;
    let falling = collapse(picture, rest, stable);
    let panels: Vec<usize> = [Some(stable).filter(|&k| k > 0), falling].into_iter().flatten().collect();
    if panels.is_empty() {
        return None;
    }
    let second = format!("Displacement since the bridge came to rest under {}", words::force(rest.load));
    let (mut sheet, mut y) = Sheet::titled("displacement", &picture.title, &second);
    for (n, &k) in panels.iter().enumerate() {
        let letter = char::from(b'a' + (n % 26) as u8);
        y = one(&mut sheet, y, picture, rest, k, letter)? + 12.0;
    }
    let caption = "Nothing is exaggerated: particles and blocks stand where they are. Arrows show the direction of the mean displacement in squares of a grid; their lengths are proportional within a panel, cut at the end of its scale. A sharp change of colour inside the fill is a band in which it shears.";
    Some(sheet.end(y - 6.0, caption))
}

/// The first state after the last stable one in which something has clearly moved, or the last of all.
fn collapse(picture: &Picture, rest: &Snapshot, stable: usize) -> Option<usize> {
    let after: Vec<usize> = (stable + 1..picture.snapshots.len()).filter(|&k| fits(picture, k)).collect();
    let far = CLEARLY * 2.0 * discs::mean_radius(picture);
    let moved = |k: &usize| sizes(&moves(picture, rest, &picture.snapshots[*k])).any(|u| u >= far);
    after.iter().copied().find(moved).or(after.last().copied())
}

/// A place and how it moved [m].
type Move = (Point, Point);

/// Every particle, then every free block at its centroid.
fn moves(picture: &Picture, rest: &Snapshot, state: &Snapshot) -> Vec<Move> {
    let particles =
        state.particles.iter().zip(&rest.particles).map(|(now, then)| (now.centre, sub(now.centre, then.centre)));
    let free = picture.shapes.iter().enumerate().filter(|(_, s)| !s.held);
    let blocks = free.map(|(k, shape)| {
        let (c, m) = (centroid(&shape.outline), state.motions[k].translation);
        ([c[0] + m[0], c[1] + m[1]], sub(m, rest.motions[k].translation))
    });
    particles.chain(blocks).collect()
}

fn sub(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1]]
}

fn sizes(moves: &[Move]) -> impl Iterator<Item = f64> + '_ {
    moves.iter().map(|(_, u)| u[0].hypot(u[1]))
}

fn one(sheet: &mut Sheet, top: f64, picture: &Picture, rest: &Snapshot, k: usize, letter: char) -> Option<f64> {
    let state = &picture.snapshots[k];
    let moves = moves(picture, rest, state);
    let largest = sizes(&moves).filter(|u| u.is_finite()).fold(0.0, f64::max);
    let end = 1e3 * quantile(sizes(&moves), SHARE);
    let scale = Scale::upto("displacement [mm]", [end, 1e3 * largest], 6, blue_for_much);
    // What falls far out of the picture does not make the bridge small.
    let extent = draw::extent(picture)?;
    let text = format!("({letter}) {}; largest displacement {}", load(picture, k), words::metres(largest));
    let colour = |u: Point| scale.of(1e3 * u[0].hypot(u[1]));
    let y = panel(sheet, extent, top, &format!("panel-{letter}"), &text, |sheet, view| {
        discs::draw(sheet, view, picture, Some(state), |p| colour(moves[p].1).into());
        let mut of_blocks = moves[picture.particles.len()..].iter().map(|(_, by)| colour(*by));
        coloured(sheet, view, picture, state, THIN, |_| of_blocks.next().unwrap_or_default());
        arrows(sheet, view, &moves, scale.axis.range[1] / 1e3);
    });
    Some(scale.draw(sheet, MARGIN, 0.62 * WIDTH, y))
}

/// One arrow a square of the sheet, for the mean displacement of what lies in it.
fn arrows(sheet: &mut Sheet, view: &View, moves: &[Move], full: f64) {
    let spots: Vec<Point> = moves.iter().map(|(at, _)| view.spot(*at)).collect();
    sheet.open("arrows");
    for members in cells(&spots, GRID).into_values() {
        let count = members.len() as f64;
        let mean = |of: &dyn Fn(usize) -> Point| {
            let sum = members.iter().fold([0.0, 0.0], |s, &k| [s[0] + of(k)[0], s[1] + of(k)[1]]);
            [sum[0] / count, sum[1] / count]
        };
        let (at, u) = (mean(&|k| spots[k]), mean(&|k| moves[k].1));
        let size = u[0].hypot(u[1]);
        let length = LONGEST * (size / full).min(1.0);
        if length > 3.0 {
            let half = [0.5 * length * u[0] / size, -0.5 * length * u[1] / size];
            let (tail, tip) = ([at[0] - half[0], at[1] - half[1]], [at[0] + half[0], at[1] + half[1]]);
            // A white rim tells an arrow from dark and from light ground.
            sheet.line(tail, tip, Pen::line("white", 2.4));
            sheet.arrow(tail, tip, Pen::line(LOAD, 1.1).class("moves"));
        }
    }
    sheet.close();
}
