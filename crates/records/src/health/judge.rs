//! Who decides: what the caller expects, leaves out and accepts, and where findings go.

use crate::series::title;
use crate::{Channel, Done, Finding, Place, Recording};
use findings::Severity;

/// The peak that a channel is expected to have, from a model or a sister bridge; its size is needed to a factor of five only.
#[derive(Debug, Clone, PartialEq)]
pub struct Expected {
    /// Name of the channel.
    pub name: String,
    /// Its line; None for all lines.
    pub line: Option<String>,
    /// Signed value of largest size [SI].
    pub peak: f64,
}

/// A channel that the caller leaves out.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LeaveOut {
    /// Run; None for all runs.
    pub run: Option<String>,
    /// Name of the channel.
    pub name: String,
    /// Its line; None for all lines.
    pub line: Option<String>,
    /// Why, in words; without a reason nothing is left out.
    pub reason: String,
}

/// A finding that the caller accepts: the channel is used in spite of it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Accept {
    /// Code of the finding, `R041`.
    pub code: String,
    /// Run; None for all runs.
    pub run: Option<String>,
    /// Name of the channel; None for all.
    pub name: Option<String>,
    /// Its line; None for all lines.
    pub line: Option<String>,
    /// Why, in words; without a reason nothing is accepted.
    pub reason: String,
}

/// How closely records are looked at.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Scrutiny {
    /// Expected peaks, by which units and signs are judged; without them sister channels and runs are compared.
    pub expected: Vec<Expected>,
    /// Channels left out by hand.
    pub leave_out: Vec<LeaveOut>,
    /// Findings accepted by hand.
    pub accept: Vec<Accept>,
}

/// Longest gap that is bridged by a straight line [samples]. Five at 200 Hz are 25 ms, in which a train at 65 km/h moves 0.45 m, less
/// than a tenth of a span of 6 m.
pub(super) const LONGEST_GAP: usize = 5;

/// Codes of findings that no word can mend: without a clock that runs forward nothing can be computed.
const NOT_ACCEPTED: [&str; 4] = ["R030", "R031", "R033", "R013"];

/// Collects what was found and done.
pub(super) struct Judge<'a> {
    pub scrutiny: &'a Scrutiny,
    pub findings: Vec<Finding>,
    pub done: Vec<Done>,
}

impl Judge<'_> {
    /// Something to look at, nothing left out.
    pub(super) fn warn(
        &mut self,
        run: &Recording,
        channel: Option<usize>,
        code: &'static str,
        samples: Option<[usize; 2]>,
        [message, help]: [&str; 2],
    ) {
        let place = place(run, channel, samples);
        self.findings.push(Finding::new(Severity::Warning, code, place, message, help));
    }

    /// A fault of a channel, or of the clock of all of them: what it is about is left out, unless the caller accepts that.
    pub(super) fn fault(
        &mut self,
        run: &mut Recording,
        channel: Option<usize>,
        code: &'static str,
        samples: Option<[usize; 2]>,
        [message, help]: [&str; 2],
    ) {
        let place = place(run, channel, samples);
        let (mut out, mut reasons) = (0, Vec::new());
        let meant = run.channels.iter_mut().enumerate().filter(|(k, _)| channel.is_none_or(|only| only == *k));
        for (_, target) in meant {
            if let Some(reason) = self.accepted(code, &run.name, target) {
                reasons.push(reason);
                continue;
            }
            out += 1;
            target.left_out.get_or_insert_with(|| format!("{code}: {message}"));
        }
        let finding = if out == 0 && !reasons.is_empty() {
            let message = format!("{message}; used all the same: {}", reasons[0]);
            Finding::new(Severity::Warning, code, place, message, "")
        } else {
            let what = if channel.is_some() { "channel" } else { "run" };
            Finding::new(Severity::Error, code, place, format!("{message}; the {what} is left out"), help)
        };
        self.findings.push(finding);
    }

    fn accepted(&self, code: &str, run: &str, channel: &Channel) -> Option<String> {
        let meant = |accept: &&Accept| {
            accept.code == code
                && fits(&accept.run, run)
                && fits(&accept.name, &channel.name)
                && fits(&accept.line, &channel.line)
                && !accept.reason.trim().is_empty()
        };
        let found = self.scrutiny.accept.iter().find(meant).filter(|_| !NOT_ACCEPTED.contains(&code));
        found.map(|accept| accept.reason.clone())
    }

    /// The expected peak of a channel [SI].
    pub(super) fn expected(&self, channel: &Channel) -> Option<f64> {
        let is_peak = |peak: f64| peak.is_finite() && peak != 0.0;
        let meant = |one: &&Expected| one.name == channel.name && fits(&one.line, &channel.line) && is_peak(one.peak);
        // An entry for the line counts more than one for all lines.
        let mut all = self.scrutiny.expected.iter().filter(meant);
        let own = all.clone().find(|one| one.line.is_some());
        own.or_else(|| all.next()).map(|one| one.peak)
    }

    /// Leaves out what the caller says.
    pub(super) fn sort_out_by_hand(&mut self, runs: &mut [Recording]) {
        for accept in self.scrutiny.accept.iter().filter(|accept| accept.reason.trim().is_empty()) {
            let message = format!("{} is accepted without a reason; it is not accepted", accept.code);
            self.findings.push(Finding::new(Severity::Error, "R051", Place::default(), message, "say why"));
        }
        for entry in &self.scrutiny.leave_out {
            let name = title(&entry.name, entry.line.as_deref().unwrap_or_default());
            if entry.reason.trim().is_empty() {
                let message = format!("`{name}` is left out without a reason; it is not left out");
                self.findings.push(Finding::new(Severity::Error, "R051", Place::default(), message, "say why"));
                continue;
            }
            let mut met = false;
            for run in runs.iter_mut().filter(|run| fits(&entry.run, &run.name)) {
                let meant = |channel: &&mut Channel| channel.name == entry.name && fits(&entry.line, &channel.line);
                for channel in run.channels.iter_mut().filter(meant) {
                    met = true;
                    channel.left_out = Some(format!("by hand: {}", entry.reason.trim()));
                    let place = Place { run: run.name.clone(), channel: channel.title(), ..Place::default() };
                    let message = format!("left out by hand: {}", entry.reason.trim());
                    self.findings.push(Finding::new(Severity::Note, "R050", place, message, ""));
                }
            }
            if !met {
                let message = format!("`{name}` is to be left out but is in no run it is asked for");
                let mut names: Vec<String> = runs.iter().flat_map(|run| &run.channels).map(Channel::title).collect();
                names.sort();
                names.dedup();
                names.truncate(20);
                let help = format!("channels are: {}", names.join(", "));
                self.findings.push(Finding::new(Severity::Error, "R052", Place::default(), message, help));
            }
        }
    }
}

/// Whether a run, a channel or a line is the one that is asked for, or all of them are.
fn fits(asked: &Option<String>, own: &str) -> bool {
    asked.as_deref().is_none_or(|asked| asked == own)
}

fn place(run: &Recording, channel: Option<usize>, samples: Option<[usize; 2]>) -> Place {
    let channel = channel.map(|index| &run.channels[index]);
    let lines = samples.and_then(|samples| {
        let of = |sample: usize| run.lines.get(sample).map(|line| *line as usize).filter(|line| *line > 0);
        Some([of(samples[0])?, of(samples[1])?])
    });
    Place {
        run: run.name.clone(),
        lines,
        column: channel.map(|channel| channel.column).filter(|column| *column > 0),
        channel: channel.map_or(String::new(), Channel::title),
        time: samples.and_then(|samples| run.times.get(samples[0]).copied()),
    }
}
