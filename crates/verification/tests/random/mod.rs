//! What the bridges drawn by several tests share: numbers by a seed, and the parts of a bridge file that all of them have. What is drawn from
//! which range is for each test to say.

#![expect(dead_code, reason = "each test draws a part of it")]

use std::fmt::Write;
use std::ops::Range;

/// The seeds that a variable of the environment asks for, as 0..500.
pub(crate) fn seeds(variable: &str, without: Range<u64>) -> Range<u64> {
    let Ok(asked) = std::env::var(variable) else { return without };
    let (from, to) = asked.split_once("..").expect("seeds are asked for as 0..500");
    from.parse().expect("a number")..to.parse().expect("a number")
}

/// Numbers that look random and are the same every time: splitmix64.
pub(crate) struct Dice(pub u64);

impl Dice {
    pub(crate) fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }
    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }
    /// Evenly over the decades.
    pub(crate) fn decades(&mut self, low: f64, high: f64) -> f64 {
        low * (high / low).powf(self.unit())
    }
    pub(crate) fn count(&mut self, low: usize, high: usize) -> usize {
        low + ((high - low + 1) as f64 * self.unit()) as usize
    }
    pub(crate) fn often(&mut self, share: f64) -> bool {
        self.unit() < share
    }
    pub(crate) fn of<'a>(&mut self, words: &[&'a str]) -> &'a str {
        words[self.count(0, words.len() - 1)]
    }
    /// What engineers write for the most part, anything that is legal every fourth time.
    pub(crate) fn usual(&mut self, [low, high]: [f64; 2], [least, most]: [f64; 2]) -> f64 {
        if self.often(0.75) { self.decades(low, high) } else { self.decades(least, most) }
    }
    /// Rise over span of a profile: within a range, pointed ones from 0.55 up.
    pub(crate) fn rise(&mut self, profile: &str, [least, most]: [f64; 2], pointed: f64) -> f64 {
        match profile {
            "semicircular" => 0.5,
            "pointed" => self.between(0.55, pointed),
            _ => self.between(least, most),
        }
    }
}

/// An arch of one or more rings.
pub(crate) struct Arch<'a> {
    pub profile: &'a str,
    /// Clear span [m].
    pub span: f64,
    pub rings: usize,
    /// Of all rings together [m].
    pub thickness: f64,
    /// In each ring.
    pub voussoirs: usize,
}

impl Arch<'_> {
    /// Writes a span of some rise [m].
    pub(crate) fn write(&self, rise: f64, page: &mut String) {
        begin_span(self.profile, self.span, rise, page);
        for _ in 0..self.rings {
            let each = self.thickness / self.rings as f64;
            let _ = writeln!(page, "[[span.ring]]\nthickness = \"{each:.4} m\"\nvoussoirs = {}", self.voussoirs);
        }
        page.push('\n');
    }
}

/// The head of a span; its rings follow. A semicircle has the rise that it has.
pub(crate) fn begin_span(profile: &str, span: f64, rise: f64, page: &mut String) {
    let _ = writeln!(page, "[[span]]\nprofile = \"{profile}\"\nspan = \"{span:.3} m\"");
    if profile != "semicircular" {
        let _ = writeln!(page, "rise = \"{rise:.3} m\"");
    }
}

/// A pier [m].
pub(crate) fn pier(width: f64, height: f64, courses: usize, page: &mut String) {
    let _ = writeln!(page, "[[pier]]\nwidth = \"{width:.3} m\"\nheight = \"{height:.3} m\"\ncourses = {courses}\n");
}

/// Numbers with a unit, as the elements of a list.
pub(crate) fn quantities(values: impl Iterator<Item = f64>, decimals: usize, unit: &str) -> String {
    values.map(|value| format!("\"{value:.decimals$} {unit}\"")).collect::<Vec<_>>().join(", ")
}
