//! What is done to the command and its files, counted: files mutated, runs killed, asked to end and put beside one another, disks full and
//! folders read-only. No case may panic or lose a result. Each part runs in small here, and in full where it is asked for:
//!
//! ```sh
//! cargo test --release -p cli --test robustness -- --ignored --nocapture --test-threads 1
//! ```
//!
//! `EXTRADOS_MUTANTS` and `EXTRADOS_KILLS` are the numbers of mutated files and of killed runs of a command, `EXTRADOS_SEED` where they
//! begin. Figures of a full run stand in docs/verification/robustness.md.

#![allow(clippy::print_stdout)]

mod disks;
mod kills;
mod mutants;
mod passing_on;
#[path = "../it/stage.rs"]
#[expect(dead_code, reason = "tests of the command need more of it")]
mod stage;
mod tally;
#[path = "../it/tiny.rs"]
mod tiny;
mod works;

/// A whole number from the environment, or another one.
fn number(name: &str, otherwise: u64) -> u64 {
    std::env::var(name).ok().and_then(|text| text.parse().ok()).unwrap_or(otherwise)
}

/// Numbers that look random and are the same every time (splitmix64).
struct Draws(u64);

impl Draws {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Below a bound.
    fn below(&mut self, bound: usize) -> usize {
        (self.next() % bound.max(1) as u64) as usize
    }
}
