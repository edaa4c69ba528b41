//! G-code: G0 moves the pen up, G1 to G3 draw, in the plane of X and Y; Z and feeds are left out.
//!
//! A line's words are a letter and a number each, with comments in parentheses or after a semicolon. Those that only
//! matter to a machine tool are passed over; those that would change where it goes are told, as are programs (O words,
//! parameters, expressions), which are more than a drawing.

use std::ops::Range;
use std::sync::Arc;

use kurbo::{Point, Vec2};

use super::Reading;
use super::pen::Pen;

const INCH: f64 = 25.4;
/// G words, times ten, that do not change where the pen goes.
const PASSED_OVER: [i64; 19] =
    [40, 80, 400, 430, 431, 490, 500, 540, 610, 611, 640, 690, 800, 930, 940, 950, 970, 980, 990];

/// A word of a line.
#[derive(Clone)]
struct Word {
    letter: char,
    number: f64,
    at: Range<usize>,
}

/// How the words that follow are understood.
struct Mode {
    motion: Option<u8>,
    unit: f64,
    is_absolute: bool,
    has_absolute_centres: bool,
    is_over: bool,
    has_z: bool,
}

pub(super) fn read(reading: &mut Reading) {
    let text = Arc::clone(&reading.text);
    let mut mode =
        Mode { motion: None, unit: 1.0, is_absolute: true, has_absolute_centres: false, is_over: false, has_z: false };
    let mut pen = Pen::new();
    let mut start = 0;
    for line in text.split_inclusive('\n') {
        let words = words(reading, line, start);
        block(reading, &mut mode, &mut pen, &words);
        start += line.len();
        if mode.is_over {
            break;
        }
    }
    let at = pen.at;
    pen.lift(reading, at);
}

/// The words of a line that begins at a byte of the text.
fn words(reading: &mut Reading, line: &str, start: usize) -> Vec<Word> {
    let (mut words, mut rest) = (Vec::new(), line);
    loop {
        rest = rest.trim_start();
        let at = start + line.len() - rest.len();
        let Some(first) = rest.chars().next() else { return words };
        match first {
            ';' | '%' => return words,
            '/' => rest = &rest[1..],
            '(' => match rest.find(')') {
                Some(end) => rest = &rest[end + 1..],
                None => {
                    reading.wrong("F002", at..at + 1, "this comment has no end", "a comment ends with `)` in its line");
                    return words;
                }
            },
            _ if first.is_ascii_alphabetic() && !"Oo".contains(first) => {
                let after = rest[1..].trim_start();
                let is_part = |c: char| c.is_ascii_digit() || "+-.".contains(c);
                let end = after.find(|c| !is_part(c)).unwrap_or(after.len());
                let last = at + (rest.len() - after.len()) + end;
                match after[..end].parse::<f64>().ok().filter(|number| number.is_finite()) {
                    Some(number) => words.push(Word { letter: first.to_ascii_uppercase(), number, at: at..last }),
                    None if after.starts_with(['#', '[']) => {
                        program(reading, at..last.max(at + 1));
                        return words;
                    }
                    None => reading.wrong(
                        "F004",
                        at..last,
                        format!("`{first}` is followed by no number"),
                        "a word is a letter and a number",
                    ),
                }
                rest = &after[end..];
            }
            'O' | 'o' | '#' | '[' => {
                program(reading, at..at + 1);
                return words;
            }
            _ => {
                let end = at + first.len_utf8();
                reading.wrong("F002", at..end, format!("`{first}` begins no word"), "a word is a letter and a number");
                return words;
            }
        }
    }
}

fn program(reading: &mut Reading, at: Range<usize>) {
    reading.wrong(
        "F003",
        at,
        "subprograms, parameters and expressions are not worked out",
        "let its own program write plain moves",
    );
}

/// Does what a line says: modes first, then the move.
fn block(reading: &mut Reading, mode: &mut Mode, pen: &mut Pen, words: &[Word]) {
    for word in words {
        match (word.letter, (word.number * 10.0).round() as i64) {
            ('G', 0 | 10 | 20 | 30) => mode.motion = Some(word.number as u8),
            ('G', 170) => {}
            ('G', 180 | 190) => reading.wrong("F003", word.at.clone(), "only the plane of X and Y (G17) is drawn", ""),
            ('G', 200) => mode.unit = INCH,
            ('G', 210) => mode.unit = 1.0,
            ('G', 900) => mode.is_absolute = true,
            ('G', 910) => mode.is_absolute = false,
            ('G', 901) => mode.has_absolute_centres = true,
            ('G', 911) => mode.has_absolute_centres = false,
            ('G', code) if PASSED_OVER.contains(&code) => {}
            ('G', _) => {
                let message = format!("G{} is not drawn", word.number);
                reading.wrong("F003", word.at.clone(), message, "drawn are G0 to G3, in G17, G20 or G21, G90 or G91");
            }
            ('M', 20 | 300) => mode.is_over = true,
            ('M', 980 | 990) => program(reading, word.at.clone()),
            ('Z', _) if !mode.has_z => {
                mode.has_z = true;
                reading.note(word.at.clone(), "Z is left out: G0 lifts the pen, G1 to G3 draw");
            }
            _ => {}
        }
    }
    let find = |letter: char| words.iter().find(|word| word.letter == letter);
    let named: Vec<_> = "XYIJR".chars().filter_map(find).collect();
    let Some(at) = named
        .iter()
        .map(|word| word.at.clone())
        .reduce(|one, other| one.start.min(other.start)..one.end.max(other.end))
    else {
        return;
    };
    let base = if mode.is_absolute { pen.at } else { Point::ZERO };
    let axis = |letter, stays: f64| find(letter).map_or(stays, |word| word.number * mode.unit);
    let mut to = Point::new(axis('X', base.x), axis('Y', base.y));
    if !mode.is_absolute {
        to += pen.at.to_vec2();
    }
    match mode.motion {
        Some(0) => pen.lift(reading, to),
        Some(1) => pen.line(reading, to, at),
        Some(turn) => match centre(mode, pen.at, to, turn == 3, &find) {
            Ok(centre) => pen.arc(reading, centre, angle(pen.at - centre, to - centre, turn == 3), to, at),
            Err(why) => reading.wrong("F004", at, why, "I and J lead from the start to the centre; or R is the radius"),
        },
        None => {
            reading.wrong("F003", at, "this says where to go, but not how", "G0, G1, G2 or G3 has to stand before it")
        }
    }
}

/// The centre of an arc.
fn centre<'w>(
    mode: &Mode,
    from: Point,
    to: Point,
    is_left: bool,
    find: &impl Fn(char) -> Option<&'w Word>,
) -> Result<Point, &'static str> {
    let number = |letter| find(letter).map(|word| word.number * mode.unit);
    if let Some(radius) = number('R') {
        let chord = to - from;
        let half = chord.hypot() / 2.0;
        if half == 0.0 || radius.abs() < half * (1.0 - 1e-3) {
            return Err("no circle of this radius goes through both ends");
        }
        let height = (radius * radius - half * half).max(0.0).sqrt();
        // The centre of the shorter arc is on its left when it turns left; a radius below 0 asks for the longer one.
        let side = if is_left == (radius > 0.0) { 1.0 } else { -1.0 };
        return Ok(from.midpoint(to) + chord.normalize().turn_90() * (height * side));
    }
    let (i, j) = (number('I'), number('J'));
    if i.is_none() && j.is_none() {
        return Err("this arc has neither a centre nor a radius");
    }
    let centre = match mode.has_absolute_centres {
        true => Point::new(i.unwrap_or(0.0), j.unwrap_or(0.0)),
        false => from + Vec2::new(i.unwrap_or(0.0), j.unwrap_or(0.0)),
    };
    let [start, end] = [from, to].map(|point| point.distance(centre));
    if start == 0.0 || (start - end).abs() > (start * 1e-3).max(0.05) {
        return Err("the ends of this arc are not equally far from its centre");
    }
    Ok(centre)
}

/// The angle from one radius to the other, a whole turn where they are the same.
fn angle(from: Vec2, to: Vec2, is_left: bool) -> f64 {
    let angle = from.cross(to).atan2(from.dot(to));
    let turn = std::f64::consts::TAU;
    match is_left {
        true if angle <= 1e-9 => angle + turn,
        false if angle >= -1e-9 => angle - turn,
        _ => angle,
    }
}

#[cfg(test)]
mod tests {
    use kurbo::Shape as _;
    use proptest::prelude::*;

    use crate::plotfile::{Kind, Plot, read};

    fn plot(text: &str) -> Plot {
        read(Kind::GCode, "a.nc", &text.into()).unwrap_or_else(|report| panic!("{report}"))
    }

    fn codes(text: &str) -> Vec<(&'static str, String)> {
        let report = read(Kind::GCode, "a.nc", &text.into()).expect_err("mistakes");
        report.diagnostics.iter().map(|d| (d.code, report.sources.place(d.labels[0].0))).collect()
    }

    #[test]
    fn arcs_have_the_length_of_their_formula_by_centre_by_radius_and_over_half_a_turn() {
        use std::f64::consts::PI;
        for (text, length) in [
            ("G0X10Y0\nG3 X0 Y10 I-10 J0", 5.0 * PI),
            ("G0 X10 Y0 G2 X0 Y10 I-10 J0", 15.0 * PI),
            ("G0 X10\nG3 X10 Y0 I-10", 20.0 * PI),
            ("G0 X10\nG3 X0 Y10 R10", 5.0 * PI),
            ("G0 X10\nG3 X0 Y10 R-10", 15.0 * PI),
            ("G0 X10\nG2 X0 Y-10 R10", 5.0 * PI),
            ("G20 G0 X1\nG91 G3 X-1 Y1 I-1", 25.4 * PI / 2.0),
            ("G90.1 G0 X10\nG3 X0 Y10 I0 J0", 5.0 * PI),
            ("n5 g1 x 3 (a (comment) y4 ; the rest X99\nM2\nG1 X50", 5.0),
        ] {
            // The first one whose line has two G words of motion takes the last, as modes are set before a move.
            let text = text.replace("Y0 G2", "Y0\nG2");
            let plot = plot(&text);
            let drawn: f64 = plot.curves.iter().map(|curve| curve.perimeter(1e-6)).sum();
            assert!((drawn - length).abs() < 1e-3 * length, "{text}: {drawn}, not {length}");
        }
    }

    #[test]
    fn a_move_with_the_pen_up_begins_another_curve() {
        let plot = plot("G21 G90\nG0 X1 Y1 Z5\nG1 Z-1\nX2\nY2\nG0 X5\nG1 Y9\n");
        let ends: Vec<_> = plot.curves.iter().map(|curve| (curve.segments().count(), curve.bounding_box())).collect();
        assert_eq!(ends, [(2, kurbo::Rect::new(1.0, 1.0, 2.0, 2.0)), (1, kurbo::Rect::new(5.0, 2.0, 5.0, 9.0))]);
        assert_eq!(plot.notes, ["a.nc:2:10: Z is left out: G0 lifts the pen, G1 to G3 draw"]);
    }

    #[test]
    fn every_mistake_has_its_code_and_place_and_all_are_told_at_once() {
        let text = "X5\nG1 X1..2\nG18\nG3 X5 Y5 R1\n(open\nG1 X#5\nO100 sub\nG1 X1234567890123\nG1 ?\nG3 X1 Y1 I50 J0\nG2 X3\nG81 Z1\n";
        let found = codes(text);
        let expected = [
            ("F003", "a.nc:1:1"),
            ("F004", "a.nc:2:4"),
            ("F003", "a.nc:3:1"),
            ("F004", "a.nc:4:4"),
            ("F002", "a.nc:5:1"),
            ("F003", "a.nc:6:4"),
            ("F003", "a.nc:7:1"),
            ("F004", "a.nc:8:4"),
            ("F002", "a.nc:9:4"),
            ("F004", "a.nc:10:4"),
            ("F004", "a.nc:11:4"),
            ("F003", "a.nc:12:1"),
        ];
        let found: Vec<_> = found.iter().map(|(code, place)| (*code, place.as_str())).collect();
        assert_eq!(found, expected);
    }

    proptest! {
        #[test]
        fn no_text_makes_it_panic(text in "[GMXYZIJRFOgx0-9.+ \n()#;%/-]{0,80}|.{0,40}") {
            let _ = read(Kind::GCode, "a.nc", &text.as_str().into());
        }
    }
}
