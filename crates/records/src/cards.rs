//! What a code of a finding means.

const ROW: &str = "the row is left out";
const SAMPLE: &str = "the sample is missing";
const CHANNEL: &str = "the channel is left out";
const RUN: &str = "the run is left out";

// `docs/theory/records.md` holds the same table: what was found, and what is done about it.
findings::cards! {
    "R001", "no table in the file", "there is no run";
    "R002", "not UTF-8 text", "read as UTF-16 or Latin-1";
    "R003", "speed that cannot be read, or two speeds", "the caller's speed, or none";
    "R004", "lines above the headings", "not read";
    "R005", "Parquet file that cannot be read", "there is no run";
    "R006", "clock of time stamps", "times are seconds from the first";
    "R007", "dates that may be read in two ways", "there is no run";
    "R010", "no clock, or no channel", "there is no run";
    "R011", "heading without a unit", "the column is not read";
    "R012", "unknown unit", "the column is not read";
    "R013", "two columns with the same name and line", "the second is left out";
    "R014", "mapping that fits no column, or two", "the entry is not used";
    "R015", "column that the mapping does not name", "passed over";
    "R016", "column that no sensor fills", "passed over";
    "R020", "text in place of a number", SAMPLE;
    "R021", "NaN or infinite value", SAMPLE;
    "R022", "empty cell", SAMPLE;
    "R023", "row with too few cells", ROW;
    "R024", "row with too many cells", ROW;
    "R025", "row whose time is no number or stamp", ROW;
    "R026", "comment amid the data", "it is no row";
    "R027", "last line without an end, complete", "kept";
    "R028", "last line cut short", ROW;
    "R030", "too few samples", RUN;
    "R031", "time goes back: two clocks", RUN;
    "R032", "step of the clock changes: two clocks", RUN;
    "R033", "repeated time", "the row is left out; the run, where more than 5 % repeat";
    "R034", "single time out of order", ROW;
    "R035", "rows missing", "bridged where short, otherwise the run is left out";
    "R036", "values missing in a row", CHANNEL;
    "R037", "two runs of one name", "the later one gets a number";
    "R040", "dead or flat channel", CHANNEL;
    "R041", "drift", CHANNEL;
    "R042", "spike", "the sample is taken out; the channel, where there are many";
    "R043", "value held while others answer", CHANNEL;
    "R044", "unit slipped by 1000", CHANNEL;
    "R045", "swapped sign", CHANNEL;
    "R046", "level after the train differs from that before", "used, and named";
    "R050", "left out by hand", CHANNEL;
    "R051", "left out or accepted without a reason", "not done";
    "R052", "left out by hand, but not there", "not done";
    "R060", "no quiet start", "not set to zero";
    "R061", "no quiet start and end", "no drift taken off";
    "R062", "low pass that does not fit the rate", "not filtered";
    "R063", "rate that cannot be", "not resampled";
    "R064", "nothing left after cutting", "not cut";
    "R065", "no alignment found", "not aligned";
    "R066", "speed that axle timing contradicts", "used, and named";
    "R067", "level before the train in records taken as they are", "used, and named";
}
