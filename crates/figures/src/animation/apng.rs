//! Animated PNG: the first frame whole, of every other only the rectangle that changed.

use super::palette::Palette;
use crate::raster::RasterError;

/// One picture of the series.
pub(super) struct Frame {
    /// Width [pixels].
    pub width: u32,
    /// Height [pixels].
    pub height: u32,
    /// Red, green, blue, alpha of every pixel, line by line.
    pub rgba: Vec<u8>,
    /// How long it is shown [ms].
    pub milliseconds: u16,
}

/// The frames as one file that plays again and again. Frames of another size than the first are left out.
pub(super) fn pack(frames: &[Frame]) -> Result<Vec<u8>, RasterError> {
    let failed = |e: png::EncodingError| RasterError::Pack(e.to_string());
    let Some(first) = frames.first() else { return Err(RasterError::Size(0, 0)) };
    let alike = || frames.iter().filter(|f| (f.width, f.height) == (first.width, first.height));
    let palette = Palette::of(alike().map(|f| &f.rgba[..]));
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, first.width, first.height);
    encoder.set_color(png::ColorType::Indexed);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_palette(palette.colours.concat());
    // Number 0 is seen through; all others are opaque.
    encoder.set_trns(vec![0u8]);
    encoder.set_compression(png::Compression::Default);
    encoder.set_filter(png::FilterType::NoFilter);
    encoder.set_animated(alike().count() as u32, 0).map_err(failed)?;
    encoder.set_blend_op(png::BlendOp::Over).map_err(failed)?;
    encoder.set_dispose_op(png::DisposeOp::None).map_err(failed)?;
    let mut writer = encoder.write_header().map_err(failed)?;
    let mut shown: Vec<u8> = Vec::new();
    for frame in alike() {
        let now = palette.numbers(&frame.rgba);
        writer.set_frame_delay(frame.milliseconds, 1000).map_err(failed)?;
        if shown.is_empty() {
            writer.write_image_data(&now).map_err(failed)?;
        } else {
            let part = changed(&shown, &now, frame.width as usize);
            // To the corner first: a place and a size must fit the whole at any moment.
            writer.set_frame_position(0, 0).map_err(failed)?;
            writer.set_frame_dimension(part.width as u32, part.height as u32).map_err(failed)?;
            writer.set_frame_position(part.left as u32, part.top as u32).map_err(failed)?;
            writer.write_image_data(&part.numbers).map_err(failed)?;
        }
        shown = now;
    }
    writer.finish().map_err(failed)?;
    Ok(file)
}

/// A rectangle of a frame.
struct Part {
    left: usize,
    top: usize,
    width: usize,
    height: usize,
    numbers: Vec<u8>,
}

/// The smallest rectangle that holds every pixel that changed; those that did not are number 0. One pixel where
/// nothing did.
fn changed(before: &[u8], now: &[u8], width: usize) -> Part {
    let differ = |k: &usize| before[*k] != now[*k];
    let (mut left, mut right, mut top, mut bottom) = (usize::MAX, 0, usize::MAX, 0);
    for k in (0..now.len()).filter(differ) {
        let (x, y) = (k % width, k / width);
        (left, right, top, bottom) = (left.min(x), right.max(x), top.min(y), bottom.max(y));
    }
    if left > right {
        return Part { left: 0, top: 0, width: 1, height: 1, numbers: vec![0] };
    }
    let places = (top..=bottom).flat_map(|y| (left..=right).map(move |x| y * width + x));
    let numbers = places.map(|k| if differ(&k) { now[k] } else { 0 }).collect();
    Part { left, top, width: right - left + 1, height: bottom - top + 1, numbers }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn frame(colour_at: impl Fn(u32, u32) -> [u8; 3]) -> Frame {
        let pixels = (0..12u32).flat_map(|k| (0..20u32).map(move |x| (x, k)));
        let rgba = pixels.flat_map(|(x, y)| colour_at(x, y).into_iter().chain([255])).collect();
        Frame { width: 20, height: 12, rgba, milliseconds: 100 }
    }

    #[test]
    fn every_frame_reads_back_as_it_was_drawn() {
        let at = |a: u32| frame(move |x, y| if x / 4 == a && y / 5 == 1 { [200, 0, 0] } else { [240, 240, 248] });
        let frames = [at(0), at(1), at(1), at(3)];
        let file = pack(&frames).unwrap();
        let mut reader = png::Decoder::new(&file[..]).read_info().unwrap();
        assert_eq!(reader.info().animation_control.unwrap().num_frames, 4);
        let palette = reader.info().palette.clone().unwrap();
        let mut canvas = vec![0u8; 240];
        let mut buffer = vec![0; reader.output_buffer_size()];
        for frame in &frames {
            reader.next_frame(&mut buffer).unwrap();
            let part = *reader.info().frame_control().unwrap();
            for y in 0..part.height {
                for x in 0..part.width {
                    let number = buffer[(y * part.width + x) as usize];
                    if number != 0 {
                        canvas[((part.y_offset + y) * 20 + part.x_offset + x) as usize] = number;
                    }
                }
            }
            let shown: Vec<u8> = canvas.iter().flat_map(|&n| palette[3 * n as usize..][..3].iter().copied()).collect();
            let drawn: Vec<u8> = frame.rgba.chunks_exact(4).flat_map(|p| p[..3].iter().copied()).collect();
            assert_eq!(shown, drawn);
        }
    }
}
