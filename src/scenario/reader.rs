//! Reads a scenario file (TOML), and finds all that is wrong with it in one run.

mod measure;
mod plot;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::model::{Change, Expectations, Named, Scenario, Stop, Table, UntilNet};
use super::number::Number;
use super::require::Requirement;
use crate::base::word::of_letters;
use crate::base::{Diagnostic, Report, SourceId, Sources, Span};

/// Every key there is: those of a scenario, and after a dot those of its tables.
pub const KEYS: &[(&str, &[&str])] = &[
    ("title", &[]),
    ("circuit", &[]),
    ("golden", &[]),
    ("require", &[]),
    ("parameters", &[]),
    ("inputs", &[]),
    ("at", &["tick", "set"]),
    ("stop", &["ticks", "until", "limit"]),
    ("trace", &["signals"]),
    ("table", &["when", "after", "columns"]),
    ("plot", &["x", "y", "pen"]),
    ("measure", &["of", "major", "minor", "combined", "law", "printed", "end"]),
    ("expect", &["ticks", "stopped_by", "outputs", "pulses"]),
];

/// Reads the text of a scenario; `name` is what messages call it.
///
/// # Errors
/// `S001` not TOML, `S002` unknown key, `S003` value of the wrong kind, `S004` something missing or contradictory,
/// `S005` so many more errors after the first 20, `S006` a requirement that is no comparison.
pub fn parse(name: &str, text: &str) -> Result<Scenario, Report> {
    let mut sources = Sources::default();
    let source = sources.add(name, text);
    let mut reader = Reader { source, wrong: Vec::new(), untold: 0 };
    let (root, errors) = DeTable::parse_recoverable(text);
    for error in errors {
        let span = error.span().map_or(0..0, |span| span);
        let diagnostic = Diagnostic::new("S001", format!("this is not TOML: {}", error.message()));
        let span = reader.span(span);
        reader.complain(|| diagnostic.at(span, "here"));
    }
    let scenario = reader.scenario(root.get_ref());
    if reader.untold > 0 {
        let message = format!("and {} more errors in {name}", reader.untold);
        reader.wrong.push(Diagnostic::new("S005", message).help("mend the first ones, then try again"));
    }
    if reader.wrong.is_empty() { Ok(scenario) } else { Err(Report::new(sources, reader.wrong)) }
}

const NAMES: &str = "a list of names";

type Value<'t> = Spanned<DeValue<'t>>;

/// How many errors are told; the others are counted.
const MOST_ERRORS: usize = 20;

struct Reader {
    source: SourceId,
    wrong: Vec<Diagnostic>,
    untold: usize,
}

impl Reader {
    fn span(&self, range: std::ops::Range<usize>) -> Span {
        let place = |at: usize| u32::try_from(at).unwrap_or(u32::MAX);
        Span { source: self.source, start: place(range.start), end: place(range.end) }
    }

    /// Adds an error, which is made only if it is told.
    fn complain(&mut self, diagnostic: impl FnOnce() -> Diagnostic) {
        if self.wrong.len() < MOST_ERRORS {
            self.wrong.push(diagnostic());
        } else {
            self.untold += 1;
        }
    }

    fn of_kind(&mut self, value: &Value<'_>, expected: &str) {
        let span = self.span(value.span());
        self.complain(|| {
            let message = format!("expected {expected}, found {}", value.get_ref().type_str());
            Diagnostic::new("S003", message).at(span, format!("write {expected} here"))
        });
    }

    /// A number of the right kind that is too large or too small.
    fn does_not_fit(&mut self, value: &Value<'_>, fitting: &str) {
        let span = self.span(value.span());
        self.complain(|| Diagnostic::new("S003", "this number does not fit").at(span, format!("write {fitting} here")));
    }

    fn table<'v, 't>(&mut self, value: &'v Value<'t>) -> Option<&'v DeTable<'t>> {
        let table = value.get_ref().as_table();
        if table.is_none() {
            self.of_kind(value, "a table");
        }
        table
    }

    fn text(&mut self, value: &Value<'_>) -> Option<String> {
        let text = value.get_ref().as_str().map(str::to_owned);
        if text.is_none() {
            self.of_kind(value, "a text in quotes");
        }
        text
    }

    fn number(&mut self, value: &Value<'_>) -> Option<Number> {
        let number = match value.get_ref() {
            DeValue::Integer(i) => i128::from_str_radix(i.as_str(), i.radix()).ok().map(Number::Word),
            DeValue::Float(f) => f.as_str().parse().ok().filter(|f: &f64| f.is_finite()).map(Number::Real),
            DeValue::Boolean(b) => Some(Number::Word((*b).into())),
            _ => {
                self.of_kind(value, "a number");
                return None;
            }
        };
        if number.is_none() {
            self.does_not_fit(value, "a finite number");
        }
        number
    }

    fn whole<T: TryFrom<i128>>(&mut self, value: &Value<'_>, expected: &str, range: &str) -> Option<T> {
        let DeValue::Integer(i) = value.get_ref() else {
            self.of_kind(value, expected);
            return None;
        };
        let whole = i128::from_str_radix(i.as_str(), i.radix()).ok().and_then(|i| T::try_from(i).ok());
        if whole.is_none() {
            self.does_not_fit(value, &format!("{expected} of {range}"));
        }
        whole
    }

    /// A whole number, or a string, which Verilog takes for one.
    fn parameter(&mut self, value: &Value<'_>) -> Option<i64> {
        let letters = match value.get_ref() {
            DeValue::String(letters) => of_letters(letters),
            _ => None,
        };
        let number = letters.and_then(|number| i64::try_from(number).ok());
        number.or_else(|| self.whole(value, "a whole number, or a string of 1 to 8 letters", "64 bits"))
    }

    fn ticks(&mut self, value: &Value<'_>) -> Option<u64> {
        self.whole(value, "a number of ticks", "0 to 18446744073709551615")
    }

    /// Each entry of a table through `read`, with its name and place.
    fn entries<T>(
        &mut self,
        value: &Value<'_>,
        mut read: impl FnMut(&mut Self, &Value<'_>) -> Option<T>,
    ) -> Vec<Named<T>> {
        let Some(table) = self.table(value) else { return Vec::new() };
        let mut all = Vec::new();
        for (name, value) in table {
            if let Some(read) = read(self, value) {
                let span = Some(self.span(name.span()));
                all.push(Named { name: name.get_ref().to_string(), value: read, span });
            }
        }
        all.sort_by_key(|entry| entry.span);
        all
    }

    /// A list of texts; `expected` says what of.
    fn names(&mut self, value: &Value<'_>, expected: &str) -> Vec<Named<()>> {
        let Some(list) = value.get_ref().as_array() else {
            self.of_kind(value, expected);
            return Vec::new();
        };
        list.iter().filter_map(|entry| self.one_name(entry)).collect()
    }

    fn one_name(&mut self, value: &Value<'_>) -> Option<Named<()>> {
        let span = Some(self.span(value.span()));
        self.text(value).map(|name| Named { name, value: (), span })
    }

    /// Reads a table of a scenario, of the name `name`, key by key.
    fn keys_of(&mut self, name: &str, table: &DeTable<'_>, read: impl FnMut(&mut Self, &str, &Value<'_>)) {
        let known = KEYS.iter().find(|(key, _)| *key == name).map_or(&[][..], |(_, keys)| keys);
        self.keys(table, known, read);
    }

    /// Reads a table key by key; `read` gets those that are known.
    fn keys(&mut self, table: &DeTable<'_>, known: &[&str], mut read: impl FnMut(&mut Self, &str, &Value<'_>)) {
        for (key, value) in table {
            let name: &str = key.get_ref();
            if known.contains(&name) {
                read(self, name, value);
            } else {
                let span = self.span(key.span());
                self.complain(|| {
                    Diagnostic::new("S002", format!("a scenario has no key `{}` here", brief(name)))
                        .at(span, format!("known here: {}", known.join(", ")))
                        .nearest(name, known.iter().copied())
                });
            }
        }
    }

    fn scenario(&mut self, root: &DeTable<'_>) -> Scenario {
        let mut scenario = Scenario::default();
        let known: Vec<_> = KEYS.iter().map(|(key, _)| *key).collect();
        self.keys(root, &known, |reader, key, value| match key {
            "title" => scenario.title = reader.text(value).unwrap_or_default(),
            "circuit" => {
                scenario.circuit = reader.text(value).unwrap_or_default();
                scenario.circuit_span = Some(reader.span(value.span()));
            }
            "golden" => scenario.golden = reader.golden(value),
            "require" => scenario.require = reader.requirements(value),
            "parameters" => scenario.parameters = reader.entries(value, Self::parameter),
            "inputs" => scenario.inputs = reader.entries(value, Reader::number),
            "at" => scenario.changes = reader.changes(value),
            "stop" => scenario.stop = reader.stop(value),
            "trace" => scenario.trace = reader.trace(value),
            "table" => scenario.table = reader.shown_table(value),
            "plot" => scenario.plot = reader.plot(value),
            "measure" => scenario.measure = reader.measure(value),
            _ => scenario.expect = reader.expect(value),
        });
        if !root.contains_key("circuit") {
            let span = self.span(0..0);
            self.complain(|| {
                Diagnostic::new("S004", "the scenario names no circuit")
                    .at(span, "in this file")
                    .help("add a line such as: circuit = \"su1522157/interpolator\"")
            });
        }
        scenario.changes.sort_by_key(|change| change.tick);
        scenario
    }

    /// A path that no scenario or circuit can be at, for the golden trace is written there.
    fn golden(&mut self, value: &Value<'_>) -> Option<String> {
        let path = self.text(value)?;
        if !path.ends_with(".vcd") {
            self.of_kind(value, "a path that ends in .vcd");
        }
        Some(path)
    }

    fn requirements(&mut self, value: &Value<'_>) -> Vec<Named<Requirement>> {
        let mut all = Vec::new();
        for Named { name, span, .. } in self.names(value, "a list of comparisons, as in [\"minor_34 <= major_32\"]") {
            match Requirement::parse(&name) {
                Ok(value) => all.push(Named { name, value, span }),
                Err(error) => self.complain(|| {
                    let wrong = Diagnostic::new("S006", error);
                    span.into_iter().fold(wrong, |wrong, span| wrong.at(span, "here"))
                }),
            }
        }
        all
    }

    fn changes(&mut self, value: &Value<'_>) -> Vec<Change> {
        let Some(list) = value.get_ref().as_array() else {
            self.of_kind(value, "one or more [[at]] tables");
            return Vec::new();
        };
        list.iter().filter_map(|entry| self.change(entry)).collect()
    }

    fn change(&mut self, value: &Value<'_>) -> Option<Change> {
        let (mut tick, mut set) = (None, None);
        let table = self.table(value)?;
        self.keys_of("at", table, |reader, key, value| match key {
            "tick" => tick = reader.ticks(value),
            _ => set = Some(reader.entries(value, Reader::number)),
        });
        if !table.contains_key("tick") || !table.contains_key("set") {
            self.missing(value, "an [[at]] needs both `tick` and `set`, as in: tick = 3, set = { start = 1 }");
        }
        Some(Change { tick: tick?, set: set? })
    }

    fn missing(&mut self, value: &Value<'_>, message: &str) {
        let span = self.span(value.span());
        self.complain(|| Diagnostic::new("S004", message).at(span, "here"));
    }

    fn stop(&mut self, value: &Value<'_>) -> Option<Stop> {
        let (mut ticks, mut until, mut limit) = (None, None, None);
        let table = self.table(value)?;
        self.keys_of("stop", table, |reader, key, value| match key {
            "ticks" => ticks = reader.ticks(value),
            "until" => {
                let span = Some(reader.span(value.span()));
                until = reader.text(value).map(|text| UntilNet::parse(&text, span));
            }
            _ => limit = reader.ticks(value),
        });
        match (ticks, until, limit) {
            (Some(ticks), None, None) => Some(Stop::Ticks(ticks)),
            (None, Some(net), Some(limit)) => Some(Stop::Until { net, limit }),
            _ => {
                self.missing(value, "a [stop] has either `ticks`, or `until` together with a `limit` of ticks");
                None
            }
        }
    }

    fn trace(&mut self, value: &Value<'_>) -> Vec<Named<()>> {
        let mut signals = Vec::new();
        if let Some(table) = self.table(value) {
            self.keys_of("trace", table, |reader, _, value| signals = reader.names(value, NAMES));
        }
        signals
    }

    fn shown_table(&mut self, value: &Value<'_>) -> Option<Table> {
        let mut shown = Table::default();
        let table = self.table(value)?;
        self.keys_of("table", table, |reader, key, value| match key {
            "when" if value.get_ref().is_str() => shown.when.extend(reader.one_name(value)),
            "when" => shown.when = reader.names(value, NAMES),
            "after" => shown.after = reader.ticks(value).unwrap_or_default(),
            _ => shown.columns = reader.names(value, NAMES),
        });
        Some(shown)
    }

    fn expect(&mut self, value: &Value<'_>) -> Expectations {
        let mut expect = Expectations::default();
        let Some(table) = self.table(value) else { return expect };
        self.keys_of("expect", table, |reader, key, value| match key {
            "ticks" => expect.ticks = reader.ticks(value),
            "stopped_by" => expect.stopped_by = reader.stopped_by(value),
            "outputs" => expect.outputs = reader.entries(value, Reader::number),
            _ => expect.pulses = reader.entries(value, Reader::ticks),
        });
        expect
    }

    fn stopped_by(&mut self, value: &Value<'_>) -> Option<String> {
        let known = ["until", "ticks", "limit"];
        let text = self.text(value)?;
        if !known.contains(&text.as_str()) {
            self.of_kind(value, "\"until\", \"ticks\" or \"limit\"");
        }
        Some(text)
    }
}

/// A name as a message shows it.
fn brief(name: &str) -> String {
    let brief: String = name.chars().take(60).collect();
    if brief.len() < name.len() { brief + "..." } else { brief }
}

#[cfg(test)]
mod tests {
    use super::*;

    const GOOD: &str = r#"
title = "A frame"
circuit = "su1522157/interpolator"
golden = "a/frame.vcd"
require = ["minor_34 <= major_32"]
[parameters]
WIDTH = 12
[inputs]
major_32 = 0x10
slope = -0.5
[[at]]
tick = 5
set = { start_33 = 0 }
[[at]]
tick = 0
set = { start_33 = 1 }
[stop]
until = "!busy"
limit = 1_000
[trace]
signals = ["step_*"]
[table]
when = "busy"
columns = ["f"]
after = 2
[plot]
x = "x"
y = { up = 1, half_down = -0.5 }
[expect]
ticks = 7
stopped_by = "until"
outputs = { f = -1 }
pulses = { step_x_36 = 5 }
"#;

    fn errors(text: &str) -> String {
        parse("bad.toml", text).expect_err("an error").to_string()
    }

    #[test]
    fn every_key_is_read() {
        let scenario = parse("good.toml", GOOD).expect("good");
        assert_eq!(scenario.title, "A frame");
        assert_eq!(scenario.golden.as_deref(), Some("a/frame.vcd"));
        assert_eq!(scenario.require[0].value.to_string(), "minor_34 <= major_32");
        assert_eq!(scenario.parameters[0].value, 12);
        assert_eq!(scenario.inputs[0].value, Number::Word(16));
        assert_eq!(scenario.inputs[1].value, Number::Real(-0.5));
        assert_eq!(scenario.changes.iter().map(|c| c.tick).collect::<Vec<_>>(), [0, 5]);
        let Some(Stop::Until { net, limit: 1000 }) = scenario.stop else { panic!("stop") };
        assert!(!net.high && net.net == "busy");
        assert_eq!(scenario.expect.pulses[0].value, 5);
        assert_eq!(scenario.expect.ticks, Some(7));
        assert_eq!(scenario.table.expect("a table").after, 2);
        assert_eq!(scenario.plot.expect("a plot").names().collect::<Vec<_>>(), ["x", "up", "half_down"]);
    }

    #[test]
    fn an_unknown_key_is_shown_with_its_place_and_the_nearest_known_one() {
        let text = errors("circuit = \"a/b\"\n[stop]\ntick = 3\n");
        for part in ["S002", "bad.toml:3:1", "`tick`", "did you mean `ticks`?"] {
            assert!(text.contains(part), "{part} in {text}");
        }
    }

    #[test]
    fn a_requirement_that_is_no_comparison_is_shown_with_its_place() {
        let text = errors("circuit = \"a/b\"\nrequire = [\n  \"a < b\",\n  \"a + b\",\n]\n");
        assert!(text.contains("S006") && text.contains("bad.toml:4:3"), "{text}");
    }

    #[test]
    fn all_errors_of_a_file_come_at_once() {
        let text = errors("circus = 1\ntitle = 7\n[inputs]\na = \"x\"\n[stop]\nuntil = \"b\"\n[[at]]\ntick = 1\n");
        for part in [
            "`circus`",
            "names no circuit",
            "expected a text",
            "expected a number",
            "`limit` of ticks",
            "needs both `tick`",
        ] {
            assert!(text.contains(part), "{part} in {text}");
        }
    }

    #[test]
    fn what_is_no_toml_is_refused_with_its_place() {
        assert!(errors("circuit = \n").contains("bad.toml:1"));
        assert!(errors("\u{0}\u{1}").contains("S001"));
        assert!(parse("deep.toml", &"[".repeat(100_000)).is_err());
    }

    #[test]
    fn a_number_that_does_not_fit_is_told_as_such() {
        let text = "circuit = \"a/b\"\n[inputs]\na = 1e400\n[stop]\nticks = 18446744073709551616\n[parameters]\nN = \
                    -9223372036854775809\n";
        let text = errors(text);
        assert_eq!(text.matches("this number does not fit").count(), 3, "{text}");
        assert!(text.contains("a number of ticks of 0 to 18446744073709551615"), "{text}");
    }

    #[test]
    fn errors_beyond_the_twentieth_are_counted_and_take_no_time() {
        let keys: String = (0..100_000).map(|i| format!("k{i}=1\n")).collect();
        let one_line: String = (0..30_000).map(|i| format!("k{i} = ")).collect();
        let long = format!("{} = 1\n", "l".repeat(3_000_000));
        let begin = std::time::Instant::now();
        assert!(errors(&keys).contains("and 99981 more errors in bad.toml"));
        for text in [one_line, long] {
            assert!(errors(&text).len() < 20_000);
        }
        // A minute and more before: every error was compared with every key and told with its line.
        assert!(begin.elapsed().as_secs() < 10, "{:?}", begin.elapsed());
    }
}
