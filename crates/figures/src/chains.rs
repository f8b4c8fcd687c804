//! Force chains: which way the load takes through the particles.

use crate::bar::quantile;
use crate::chart::Key;
use crate::discs;
use crate::elevation::{self as draw, FAINT, INK, Sign, THRUST};
use crate::geometry::{View, round_down};
use crate::panels::{outline, shown};
use crate::sheet::{HAIR, Pen, Sheet, Spot};
use crate::{thrust, words};
use outcome::picture::{ParticleForce, Partner, Picture, Snapshot};

/// Contacts that carry more than the mean.
const STRONG: &str = "#7a1020";
/// Contacts that carry less.
const WEAK: &str = "#8fa2b5";
/// Widths are drawn in so many steps between nothing and the widest.
const STEPS: usize = 48;

/// The branch of every contact between particles, and of particles with blocks, at the last stable load, as wide as
/// its compression is large, over pale particles and blocks. None without particles or forces between them.
pub fn force_chains(picture: &Picture) -> Option<String> {
    let at = shown(picture).filter(|_| discs::drawable(picture))?;
    let state = &picture.snapshots[at];
    let forces: Vec<&ParticleForce> = state.particle_forces.iter().filter(|f| usable(picture, f)).collect();
    let size = |f: &&ParticleForce| f.compression;
    let largest = forces.iter().map(size).fold(0.0, f64::max);
    let extent = draw::extent(picture).filter(|_| largest > 0.0)?;

    let second = format!("Force chains in the fill at {}", crate::panels::load(picture, at));
    let (mut sheet, top) = Sheet::titled("chains", &picture.title, &second);
    let (frame, view) = draw::fit(extent, top, draw::TALLEST);
    let diameter = 2.0 * discs::mean_radius(picture) * view.scale;
    // All but the strongest chains are at most half a particle wide, and those no wider than one and a half.
    let scale = (0.5 * diameter / quantile(forces.iter().map(size), 0.98)).min(1.5 * diameter / largest);

    discs::pale(&mut sheet, &view, picture, Some(state));
    blocks(&mut sheet, &view, picture, state);
    let mean = forces.iter().map(size).sum::<f64>() / forces.len() as f64;
    for (class, colour, strong) in [("weak", WEAK, false), ("strong", STRONG, true)] {
        sheet.open_drawn(class, Pen::line(colour, HAIR));
        let some = forces.iter().filter(|f| (f.compression > mean) == strong);
        lines(&mut sheet, some.map(|f| (branch(&view, picture, state, f), scale * f.compression)), scale * largest);
        sheet.close();
    }
    thrust::plain(&mut sheet, &view, &picture.thrust_lines, Pen::line(THRUST, 1.5).dashed("6 3"));

    let mut y = draw::scale_bar(&mut sheet, &view, frame.bottom + 8.0);
    y = widths(&mut sheet, y + 4.0, scale, largest);
    let entries = [
        (Sign::Thrust, "line of thrust in the ring (dashed)", !picture.thrust_lines.is_empty()),
        (Sign::Support, "support", true),
    ];
    y = draw::key(&mut sheet, y, &entries);
    let caption = format!(
        "Each line joins the centres of two particles that touch, or a centre and the place where its particle touches a block. Its width is proportional to the compression between them; dark lines carry more than the mean of {}, pale ones less. Largest: {}. {} contacts of {} particles.",
        words::force(mean),
        words::force(largest),
        forces.len(),
        picture.particles.len()
    );
    Some(sheet.end(y, &caption))
}

fn usable(picture: &Picture, f: &ParticleForce) -> bool {
    let known = match f.partner {
        Partner::Particle(other) => other < picture.particles.len(),
        Partner::Shape(_) => true,
    };
    known && f.particle < picture.particles.len() && f.compression.is_finite() && f.compression > 0.0
}

/// From a particle's centre to that of its partner, or to the place where they touch.
fn branch(view: &View, picture: &Picture, state: &Snapshot, f: &ParticleForce) -> [Spot; 2] {
    let to = match f.partner {
        Partner::Particle(other) => discs::place(picture, Some(state), other),
        Partner::Shape(_) => f.point,
    };
    [view.spot(discs::place(picture, Some(state), f.particle)), view.spot(to)]
}

/// Lines with their widths, thin ones first; widths are rounded up to a step, so that few paths hold them all.
fn lines(sheet: &mut Sheet, of: impl Iterator<Item = ([Spot; 2], f64)>, widest: f64) {
    let mut steps = vec![Vec::new(); STEPS];
    for (line, width) in of {
        let step = (width / widest * STEPS as f64).ceil() as usize;
        steps[step.clamp(1, STEPS) - 1].push(line);
    }
    for (k, lines) in steps.iter().enumerate() {
        sheet.strokes(lines, widest * (k + 1) as f64 / STEPS as f64);
    }
}

/// The blocks, pale.
fn blocks(sheet: &mut Sheet, view: &View, picture: &Picture, state: &Snapshot) {
    sheet.open("blocks");
    for (k, shape) in picture.shapes.iter().enumerate() {
        let spots = view.spots(&outline(picture, Some(state), k, 1.0));
        if shape.held {
            sheet.hatched(&spots, Pen::line(INK, HAIR).class("support"));
        } else {
            sheet.polygon(&spots, Pen::shape("#fbf8f1", FAINT, HAIR).class("block"));
        }
    }
    sheet.close();
}

/// Sample lines of round forces; returns the y below.
fn widths(sheet: &mut Sheet, top: f64, scale: f64, largest: f64) -> f64 {
    let full = round_down(largest);
    let below = (0.5 * scale * full - 4.0).max(2.0) + 4.0;
    let key = Key { class: "scale-of-forces", words: 46.0, wide: 46.0, gap: 22.0, below, ..Key::CHART };
    let forces = [0.1, 0.2, 0.5, 1.0].map(|share| (share * full, words::force(share * full)));
    key.draw(sheet, top, forces, |sheet, [x, y], force| {
        sheet.line([x, y - 4.0], [x + 40.0, y - 4.0], Pen::line(STRONG, scale * force));
    })
}
