//! A palette of at most 255 colours for all frames: drawings have few, and the rims of their shapes blend between them.

/// Colours are distinguished by the upper five bits of red, green and blue.
const BINS: usize = 1 << 15;

fn bin(pixel: &[u8]) -> usize {
    (usize::from(pixel[0] >> 3) << 10) | (usize::from(pixel[1] >> 3) << 5) | usize::from(pixel[2] >> 3)
}

/// Colours, and which of them stands for each bin.
pub(super) struct Palette {
    /// Red, green, blue of each colour; number 0 is the one that shows what was there before.
    pub colours: Vec<[u8; 3]>,
    of_bin: Vec<u8>,
}

impl Palette {
    /// The most frequent colours of all pixels (red, green, blue, alpha), each the mean of its bin; every other colour
    /// is shown by the nearest one.
    pub(super) fn of<'a>(frames: impl Iterator<Item = &'a [u8]>) -> Palette {
        let mut sums = vec![[0u64; 4]; BINS];
        for pixel in frames.flat_map(|f| f.chunks_exact(4)) {
            let sum = &mut sums[bin(pixel)];
            (0..3).for_each(|c| sum[c] += u64::from(pixel[c]));
            sum[3] += 1;
        }
        let mean = |s: &[u64; 4]| [0, 1, 2].map(|c| ((s[c] + s[3] / 2) / s[3]) as u8);
        let mut used: Vec<usize> = (0..BINS).filter(|&b| sums[b][3] > 0).collect();
        used.sort_by_key(|&b| (std::cmp::Reverse(sums[b][3]), b));
        let mut colours = vec![[255, 255, 255]];
        colours.extend(used.iter().take(255).map(|&b| mean(&sums[b])));
        let distance = |a: [u8; 3], b: [u8; 3]| -> u32 { (0..3).map(|c| u32::from(a[c].abs_diff(b[c])).pow(2)).sum() };
        let mut of_bin = vec![1; BINS];
        for (rank, &b) in used.iter().enumerate() {
            let own = mean(&sums[b]);
            let nearest = || (1..colours.len()).min_by_key(|&k| distance(colours[k], own)).unwrap_or(1);
            of_bin[b] = if rank < 255 { rank + 1 } else { nearest() } as u8;
        }
        Palette { colours, of_bin }
    }

    /// The number of every pixel's colour.
    pub(super) fn numbers(&self, rgba: &[u8]) -> Vec<u8> {
        rgba.chunks_exact(4).map(|pixel| self.of_bin[bin(pixel)]).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn few_colours_are_kept_as_they_are_and_many_are_near() {
        let few = [10, 20, 30, 255, 200, 100, 50, 255, 10, 20, 30, 255];
        let palette = Palette::of([&few[..]].into_iter());
        let shown: Vec<[u8; 3]> = palette.numbers(&few).iter().map(|&n| palette.colours[n as usize]).collect();
        assert_eq!(shown, [[10, 20, 30], [200, 100, 50], [10, 20, 30]]);

        let many: Vec<u8> = (0..4000u32).flat_map(|k| [(k % 256) as u8, (k / 16) as u8, 128, 255]).collect();
        let palette = Palette::of([&many[..]].into_iter());
        assert_eq!(palette.colours.len(), 256);
        for (pixel, n) in many.chunks_exact(4).zip(palette.numbers(&many)) {
            let off = |c: &[u8; 3]| (0..3).map(|k| f64::from(c[k].abs_diff(pixel[k])).powi(2)).sum::<f64>().sqrt();
            let least = palette.colours[1..].iter().map(off).fold(f64::INFINITY, f64::min);
            // Colours of one bin are as far apart as its corners: eight times the root of three.
            assert!(n > 0 && off(&palette.colours[n as usize]) <= least + 14.0, "{pixel:?}");
        }
    }
}
