//! What a code of a finding means.

/// The card of a code.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Card {
    /// The code.
    pub code: &'static str,
    /// In a few words.
    pub title: &'static str,
    /// What is done about it.
    pub then: &'static str,
}

const fn card(code: &'static str, title: &'static str, then: &'static str) -> Card {
    Card { code, title, then }
}

const ROW: &str = "the row is left out";
const SAMPLE: &str = "the sample is missing";
const CHANNEL: &str = "the channel is left out";
const RUN: &str = "the run is left out";

/// Every card, in the order of the codes. `docs/theory/records.md` holds the same table.
pub const CARDS: &[Card] = &[
    card("R001", "no table in the file", "there is no run"),
    card("R002", "not UTF-8 text", "read as UTF-16 or Latin-1"),
    card("R003", "speed that cannot be read, or two speeds", "the caller's speed, or none"),
    card("R004", "lines above the headings", "not read"),
    card("R005", "Parquet file that cannot be read", "there is no run"),
    card("R010", "no clock, or no channel", "there is no run"),
    card("R011", "heading without a unit", "the column is not read"),
    card("R012", "unknown unit", "the column is not read"),
    card("R013", "two columns with the same name and line", "the second is left out"),
    card("R014", "mapping that fits no column, or two", "the entry is not used"),
    card("R015", "column that the mapping does not name", "passed over"),
    card("R020", "text in place of a number", SAMPLE),
    card("R021", "NaN or infinite value", SAMPLE),
    card("R022", "empty cell", SAMPLE),
    card("R023", "row with too few cells", ROW),
    card("R024", "row with too many cells", ROW),
    card("R025", "row whose time is no number", ROW),
    card("R026", "comment amid the data", "it is no row"),
    card("R027", "last line without an end, complete", "kept"),
    card("R028", "last line cut short", ROW),
    card("R030", "too few samples", RUN),
    card("R031", "time goes back: two clocks", RUN),
    card("R032", "step of the clock changes: two clocks", RUN),
    card("R033", "repeated time", "the row is left out; the run, where more than 5 % repeat"),
    card("R034", "single time out of order", ROW),
    card("R035", "rows missing", "bridged where short, otherwise the run is left out"),
    card("R036", "values missing in a row", CHANNEL),
    card("R037", "two runs of one name", "the later one gets a number"),
    card("R040", "dead or flat channel", CHANNEL),
    card("R041", "drift", CHANNEL),
    card("R042", "spike", "the sample is taken out; the channel, where there are many"),
    card("R043", "value held while others answer", CHANNEL),
    card("R044", "unit slipped by 1000", CHANNEL),
    card("R045", "swapped sign", CHANNEL),
    card("R046", "level after the train differs from that before", "used, and named"),
    card("R050", "left out by hand", CHANNEL),
    card("R051", "left out or accepted without a reason", "not done"),
    card("R052", "left out by hand, but not there", "not done"),
    card("R060", "no quiet start", "not set to zero"),
    card("R061", "no quiet start and end", "no drift taken off"),
    card("R062", "low pass that does not fit the rate", "not filtered"),
    card("R063", "rate that cannot be", "not resampled"),
    card("R064", "nothing left after cutting", "not cut"),
    card("R065", "no alignment found", "not aligned"),
    card("R066", "speed that axle timing contradicts", "used, and named"),
];
