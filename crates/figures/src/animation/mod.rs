//! The run as moving pictures: every load step at rest, then the way down.

mod apng;
mod inset;
mod palette;

use crate::discs;
use crate::elevation as draw;
use crate::frames::{BANDS, Frames};
use crate::raster::{RasterError, options, pixels};
use crate::sheet::{MARGIN, Sheet, Style, TITLE, WIDTH};
use crate::words;
use apng::Frame;
use outcome::picture::Picture;

/// Width of the pictures [pixels].
const PIXELS: u32 = 960;
/// Most frames: a run of more is thinned evenly, its last stable and its last state kept.
const MOST: usize = 64;
/// Tallest bridge on a frame.
const TALLEST: f64 = 420.0;
/// How long a step at rest, a step of the collapse, and the last frame are shown [ms].
const SHOWN: [u16; 3] = [400, 160, 2500];

/// The run as an animated PNG that any browser plays: the bridge, the load, and how far the load path has come. None
/// where nothing moves, or in only one state.
///
/// # Errors
/// A drawing of which no PNG can be made.
pub fn animation(picture: &Picture) -> Result<Option<Vec<u8>>, RasterError> {
    let Some(run) = Frames::of(picture).filter(|run| run.usable.len() > 1) else { return Ok(None) };
    let options = options();
    let chosen = thinned(&run.usable, picture.last_stable);
    let mut frames = Vec::with_capacity(chosen.len());
    for (n, &k) in chosen.iter().enumerate() {
        let pixels = pixels(&frame(picture, &run, k), PIXELS, &options)?;
        let falling = picture.last_stable.is_none_or(|stable| k > stable);
        let milliseconds = if n + 1 == chosen.len() { SHOWN[2] } else { SHOWN[usize::from(falling)] };
        frames.push(Frame { width: pixels.width(), height: pixels.height(), rgba: pixels.take(), milliseconds });
    }
    apng::pack(&frames).map(Some)
}

/// At most [`MOST`] of the states, evenly, with the last stable one and the last.
fn thinned(usable: &[usize], last_stable: Option<usize>) -> Vec<usize> {
    let share = usable.len().div_ceil(MOST - 1).max(1);
    let last = usable.last().copied();
    let kept = |(n, k): (usize, &usize)| n % share == 0 || last_stable == Some(*k) || last == Some(*k);
    usable.iter().enumerate().filter(|&(n, k)| kept((n, k))).map(|(_, k)| *k).take(MOST + 1).collect()
}

/// One frame, of the same size as all others.
fn frame(picture: &Picture, run: &Frames, snapshot: usize) -> String {
    let (mut sheet, top) = Sheet::titled("frame", &picture.title, &format!("Displacements {}", run.how()));
    let (area, view) = draw::fit(run.extent, top, TALLEST);
    sheet.open_clipped("bridge", "room", area);
    run.draw(&mut sheet, &view, picture, Some(snapshot));
    sheet.close();

    let below = area.bottom + 10.0;
    let load = picture.snapshots[snapshot].load;
    let (name, size) =
        if picture.moves_supports { ("Support movement", words::metres(load)) } else { ("Load", words::force(load)) };
    let (colour, state) = state(picture, snapshot);
    let big = Style { size: 1.6 * TITLE, ..Style::bold() };
    sheet.text([MARGIN, below + 20.0], name, Style::default());
    sheet.text([MARGIN, below + 50.0], &size, big);
    sheet.text([MARGIN, below + 74.0], &state, Style { colour, ..Style::default() });
    let mut y = draw::scale_bar(&mut sheet, &view, below + 84.0);
    inset::draw(&mut sheet, picture, snapshot, [0.5 * WIDTH, below]);
    y = y.max(below + inset::HEIGHT);
    if discs::drawable(picture) {
        y = discs::key(&mut sheet, y, picture, true);
        y = sheet.caption(y, BANDS);
    }
    sheet.finish(y)
}

/// Whether a state is at rest, and its colour.
fn state(picture: &Picture, snapshot: usize) -> (&'static str, String) {
    match picture.last_stable {
        Some(stable) if snapshot == stable => (draw::THRUST, "at rest: the last stable state".into()),
        Some(stable) if snapshot < stable => (draw::THRUST, "at rest".into()),
        Some(stable) => {
            let after = picture.snapshots.len() - stable - 1;
            (draw::LOAD, format!("does not come to rest: {} of {after}", snapshot - stable))
        }
        None => (draw::LOAD, "does not come to rest".into()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_runs_are_thinned_and_keep_what_matters() {
        let usable: Vec<usize> = (0..1000).collect();
        let found = thinned(&usable, Some(777));
        assert!(found.len() <= MOST + 1 && found.contains(&777) && found.last() == Some(&999), "{found:?}");
        assert_eq!(thinned(&[0, 1, 2], Some(1)), [0, 1, 2]);
    }
}
