//! Every evaluation that was ever done, by the exact bits of what was asked; as text, for a file of the caller's.
//!
//! One line is one evaluation: the request, the point and the answer as hexadecimal bits, and a checksum. A line that is not
//! whole, as the last one of a killed run, is passed over and counted.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::sync::Arc;

use crate::forward::{Evaluation, Failure, Request, Response, Samples};

const HEAD: &str = "evaluations 1 ";

#[derive(Debug, Clone)]
struct Entry {
    evaluation: Arc<Evaluation>,
    /// The search that used it last.
    used_by: u64,
}

/// Evaluations by request and point.
#[derive(Debug, Clone)]
pub struct Log {
    identity: String,
    entries: BTreeMap<Request, BTreeMap<Vec<u64>, Entry>>,
    searches: u64,
}

/// Why a log cannot be taken up.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Unreadable {
    /// It does not begin as a log does.
    NoLog,
    /// It holds the evaluations of something else.
    Other {
        /// Whose they are.
        identity: String,
    },
}

fn bits(point: &[f64]) -> Vec<u64> {
    point.iter().map(|value| value.to_bits()).collect()
}

impl Log {
    /// An empty log. `identity` names all that decides the answers beside the point: model, train, program.
    pub fn new(identity: &str) -> Self {
        let identity = identity.replace(['\n', '\r'], " ");
        Self { identity, entries: BTreeMap::new(), searches: 0 }
    }

    /// The first line of its file.
    pub fn head(&self) -> String {
        format!("{HEAD}{}", self.identity)
    }

    /// How many evaluations it holds.
    pub fn len(&self) -> usize {
        self.entries.values().map(BTreeMap::len).sum()
    }

    /// Whether it holds none.
    pub fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    /// The whole log as text, in the order of its keys.
    pub fn text(&self) -> String {
        let mut text = self.head() + "\n";
        for (request, entries) in &self.entries {
            for (point, entry) in entries {
                text += &line(request, point, &entry.evaluation);
                text.push('\n');
            }
        }
        text
    }

    /// Reads a log back. Gives it with the number of lines that were not whole and were passed over.
    ///
    /// # Errors
    /// A text that is no log, or the log of something else.
    pub fn read(identity: &str, text: &str) -> Result<(Self, usize), Unreadable> {
        let mut log = Self::new(identity);
        let mut lines = text.lines();
        let head = lines.next().and_then(|line| line.strip_prefix(HEAD)).ok_or(Unreadable::NoLog)?;
        if head != log.identity {
            return Err(Unreadable::Other { identity: head.to_owned() });
        }
        let mut broken = 0;
        for text in lines.filter(|line| !line.is_empty()) {
            match parse(text) {
                Some((request, point, evaluation)) => log.put(&request, point, evaluation),
                None => broken += 1,
            }
        }
        Ok((log, broken))
    }

    /// Drops what does not have the shape that is asked for.
    pub(crate) fn keep_sound(&mut self, sound: impl Fn(&Request, usize, &Evaluation) -> bool) {
        for (request, entries) in &mut self.entries {
            entries.retain(|point, entry| sound(request, point.len(), &entry.evaluation));
        }
    }

    /// A search begins: what it uses is counted anew.
    pub(crate) fn begin_search(&mut self) {
        self.searches += 1;
    }

    /// What is known of a point. An answer with derivatives also answers without them.
    pub(crate) fn get(&self, point: &[f64], request: &Request) -> Option<Arc<Evaluation>> {
        let key = bits(point);
        let found = |request: &Request| self.entries.get(request)?.get(&key).map(|entry| entry.evaluation.clone());
        found(request).or_else(|| (!request.sensitivities).then(|| found(&with_sensitivities(request)))?)
    }

    /// Marks a point as used by the present search; says whether it was not before.
    pub(crate) fn uses(&mut self, point: &[f64], request: &Request) -> bool {
        let (key, search) = (bits(point), self.searches);
        let known = self.entries.get(request).is_some_and(|entries| entries.contains_key(&key));
        let request = if known { request.clone() } else { with_sensitivities(request) };
        let entry = self.entries.get_mut(&request).and_then(|entries| entries.get_mut(&key));
        entry.is_some_and(|entry| std::mem::replace(&mut entry.used_by, search) != search)
    }

    /// Adds an evaluation and gives its line.
    pub(crate) fn add(&mut self, point: &[f64], request: &Request, evaluation: Evaluation, wanted: bool) -> String {
        let key = bits(point);
        let text = if wanted { line(request, &key, &evaluation) } else { String::new() };
        self.put(request, key, evaluation);
        text
    }

    fn put(&mut self, request: &Request, point: Vec<u64>, evaluation: Evaluation) {
        let entry = Entry { evaluation: Arc::new(evaluation), used_by: 0 };
        self.entries.entry(request.clone()).or_default().insert(point, entry);
    }
}

fn with_sensitivities(request: &Request) -> Request {
    Request { sensitivities: true, ..request.clone() }
}

/// Sixty-four bits over the bytes of a line (FNV-1a): finds a line that was cut off or edited, nothing more.
fn checksum(text: &str) -> u64 {
    text.bytes().fold(0xcbf2_9ce4_8422_2325, |sum, byte| (sum ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

fn line(request: &Request, point: &[u64], evaluation: &Evaluation) -> String {
    let mut text = String::new();
    text += if request.sensitivities { "s " } else { "v " };
    match &request.samples {
        Samples::All => text.push('*'),
        Samples::At(places) => {
            let places = places.iter().map(|p| p.iter().map(ToString::to_string).collect::<Vec<_>>().join(","));
            text += &places.collect::<Vec<_>>().join("/");
        }
    }
    text.push(' ');
    text += &point.iter().map(|word| format!("{word:x}")).collect::<Vec<_>>().join(",");
    match evaluation {
        Ok(response) => {
            text += " = ";
            table(&mut text, &response.values);
            for derivative in &response.derivatives {
                text.push(' ');
                table(&mut text, derivative);
            }
        }
        Err(failure) => {
            let message = failure.message.replace(['\n', '\r'], " ");
            let _ = write!(text, " ! {} {message}", failure.code.replace(char::is_whitespace, "-"));
        }
    }
    let _ = write!(text, " #{:x}", checksum(&text));
    text
}

fn table(text: &mut String, values: &[Vec<f64>]) {
    for (k, row) in values.iter().enumerate() {
        if k > 0 {
            text.push('/');
        }
        *text += &row.iter().map(|value| format!("{:x}", value.to_bits())).collect::<Vec<_>>().join(",");
    }
}

fn parse(text: &str) -> Option<(Request, Vec<u64>, Evaluation)> {
    let (text, sum) = text.rsplit_once(" #")?;
    if u64::from_str_radix(sum, 16).ok()? != checksum(text) {
        return None;
    }
    let (kind, rest) = text.split_once(' ')?;
    let (places, rest) = rest.split_once(' ')?;
    let (point, rest) = rest.split_once(' ')?;
    let (mark, answer) = rest.split_once(' ')?;
    let samples = match places {
        "*" => Samples::All,
        places => Samples::At(places.split('/').map(|row| list(row, |word| word.parse().ok())).collect::<Option<_>>()?),
    };
    let request = Request { samples, sensitivities: kind == "s" };
    let point = list(point, |word| u64::from_str_radix(word, 16).ok())?;
    let evaluation = if mark == "=" {
        let mut tables = answer.split(' ').map(|table| table.split('/').map(floats).collect::<Option<Vec<_>>>());
        let values = tables.next()??;
        Ok(Response { values, derivatives: tables.collect::<Option<_>>()? })
    } else {
        let (code, message) = answer.split_once(' ')?;
        Err(Failure::new(code, message))
    };
    Some((request, point, evaluation))
}

fn list<T>(row: &str, read: impl Fn(&str) -> Option<T>) -> Option<Vec<T>> {
    row.split(',').filter(|word| !word.is_empty()).map(read).collect()
}

fn floats(row: &str) -> Option<Vec<f64>> {
    list(row, |word| u64::from_str_radix(word, 16).ok().map(f64::from_bits))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn filled() -> Log {
        let mut log = Log::new("a model");
        let slices = Request { samples: Samples::At(vec![vec![3, 4], vec![]]), sensitivities: true };
        let response = Response {
            values: vec![vec![0.1, -0.0], vec![]],
            derivatives: vec![vec![vec![1e300, 2.0], vec![]], vec![vec![f64::MIN_POSITIVE, 3.0], vec![]]],
        };
        log.add(&[1.0 / 3.0, 2.0], &slices, Ok(response), false);
        log.add(&[1.0, 2.0], &Request::all(), Err(Failure::new("not-converged", "stopped at 3.2 s # odd")), false);
        log
    }

    #[test]
    fn what_is_written_is_read_to_the_bit() {
        let log = filled();
        let (back, broken) = Log::read("a model", &log.text()).unwrap();
        assert_eq!((back.text(), broken, back.len()), (log.text(), 0, 2));
        let known = back.get(&[1.0, 2.0], &Request::all()).unwrap();
        assert_eq!(known.as_ref().as_ref().unwrap_err().message, "stopped at 3.2 s # odd");
    }

    #[test]
    fn a_torn_line_is_passed_over_and_another_model_refused() {
        let text = filled().text();
        let log_head = filled().head().len();
        for cut in 1..text.len() {
            match Log::read("a model", &text[..cut]) {
                Ok((log, broken)) => assert!(log.len() + broken <= 2),
                Err(_) => assert!(cut < log_head),
            }
        }
        let other = Log::read("another", &text);
        assert_eq!(other.unwrap_err(), Unreadable::Other { identity: "a model".to_owned() });
    }

    #[test]
    fn derivatives_answer_for_values_and_not_the_other_way_round() {
        let log = filled();
        let mut request = Request { samples: Samples::At(vec![vec![3, 4], vec![]]), sensitivities: false };
        assert!(log.get(&[1.0 / 3.0, 2.0], &request).is_some());
        request = Request { samples: Samples::All, sensitivities: true };
        assert!(log.get(&[1.0, 2.0], &request).is_none());
    }
}
