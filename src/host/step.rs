//! The operations and decisions of FIG. 19, and how they are printed.

use std::fmt;

use super::{CaseTwo, Curve, Entry, Note, Point, Refusal, Section};

/// An operation or decision of FIG. 19 that has been done, with what came of it.
#[derive(Clone, PartialEq, Debug)]
pub enum Step {
    /// 580.
    Initialise,
    /// 582 reads P0, the slope there, and the points of the first section.
    Read {
        /// The begin.
        p0: Point,
        /// The slope there.
        s0: f64,
        /// P3 and P1.
        entry: Option<Entry>,
    },
    /// 584 computes A, B, C, D and E.
    Compute(CaseTwo),
    /// 586: whether 0 < E < 1.
    Test(CaseTwo),
    /// 588 computes F and J to M.
    Parameters(CaseTwo),
    /// 590 makes words for the registers. What does not fit goes to 610 (chosen; the figure has no way out here).
    Format(Result<Section, Refusal>),
    /// 592 sends them to processor 554.
    Send {
        /// Whose words.
        section: Section,
        /// Whether it begins with a cusp or a corner.
        note: Option<Note>,
    },
    /// 594: generator and display draw.
    Display(Section),
    /// 596 carries the slope on. P1 becomes P0, which the text does not say.
    Carry(Section),
    /// 598 accepts two points, one, or none.
    Accept(Option<Entry>),
    /// 600: how many have come.
    Count(Option<Entry>),
    /// 602.
    End,
    /// 604 reads the slope for a single point, which is the end of its section.
    ReadSlope {
        /// The end.
        p1: Point,
        /// The slope there.
        s1: f64,
    },
    /// 606 computes A, B and J to M by case I. Equal slopes go to 610 (chosen; the figure divides by 0 here).
    CaseOne {
        /// The end.
        p1: Point,
        /// From P0 to it.
        curve: Result<Curve, Refusal>,
    },
    /// 610 cancels what was read last, and tells the operator.
    Cancel(Note),
}

impl Step {
    /// Its numeral in FIG. 19.
    #[must_use]
    pub fn numeral(&self) -> u16 {
        match self {
            Self::Initialise => 580,
            Self::Read { .. } => 582,
            Self::Compute(_) => 584,
            Self::Test(_) => 586,
            Self::Parameters(_) => 588,
            Self::Format(_) => 590,
            Self::Send { .. } => 592,
            Self::Display(_) => 594,
            Self::Carry(_) => 596,
            Self::Accept(_) => 598,
            Self::Count(_) => 600,
            Self::End => 602,
            Self::ReadSlope { .. } => 604,
            Self::CaseOne { .. } => 606,
            Self::Cancel(_) => 610,
        }
    }
}

/// A number with four decimals at most.
struct Short(f64);

impl fmt::Display for Short {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // Adding 0 makes -0 a plain one.
        write!(f, "{}", (self.0 * 1e4).round() / 1e4 + 0.0)
    }
}

/// Several numbers with their names, or a point.
struct Named<'a, const N: usize>([&'a str; N], [f64; N]);

impl<const N: usize> fmt::Display for Named<'_, N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (at, (name, value)) in self.0.iter().zip(self.1).enumerate() {
            let comma = if at == 0 { "" } else { ", " };
            write!(f, "{comma}{name} = {}", Short(value))?;
        }
        Ok(())
    }
}

fn point(name: &str, [x, y]: Point) -> String {
    format!("{name} = ({}, {})", Short(x), Short(y))
}

fn points(entry: &Option<Entry>) -> String {
    match *entry {
        Some(Entry::Two { p3, p1 }) => format!("{}, {}", point("P3", p3), point("P1", p1)),
        Some(Entry::One { p1, .. }) => point("P1", p1),
        None => "no point".to_owned(),
    }
}

const JKLM: [&str; 4] = ["J", "K", "L", "M"];

/// The numeral, and in words what was done.
impl fmt::Display for Step {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}  ", self.numeral())?;
        match self {
            Self::Initialise => write!(f, "begin"),
            Self::Read { p0, s0, entry } => {
                write!(f, "read {}, {}, {}", point("P0", *p0), Named(["S0"], [*s0]), points(entry))
            }
            Self::Compute(CaseTwo { a, b, c, d, e, .. }) => {
                write!(f, "compute {}", Named(["A", "B", "C", "D", "E"], [*a, *b, *c, *d, *e]))
            }
            Self::Test(two) => write!(f, "0 < E < 1? {}", if two.is_good() { "yes" } else { "no" }),
            Self::Parameters(two) => {
                write!(f, "compute {}, {}", Named(["F"], [two.f()]), Named(JKLM, two.curve().jklm))
            }
            Self::Format(Ok(Section { stroke, .. })) => {
                let [x0, y0] = stroke.from;
                write!(f, "format {}, X0 = {x0}, Y0 = {y0}", Named(JKLM, stroke.jklm.map(f64::from)))
            }
            Self::Format(Err(refusal)) => write!(f, "format: {refusal}"),
            Self::Send { section, note } => {
                write!(f, "send")?;
                for write in section.stroke.writes() {
                    write!(f, " {}:{:06o}", write.address, write.data)?;
                }
                note.iter().try_for_each(|note| write!(f, "; {note}"))
            }
            Self::Display(_) => write!(f, "draw"),
            Self::Carry(Section { s1, to, .. }) => write!(f, "{}, {}", Named(["S0"], [*s1]), point("P0", *to)),
            Self::Accept(entry) => write!(f, "accept {}", points(entry)),
            Self::Count(entry) => match entry.map_or(0, |entry| entry.points()) {
                0 => write!(f, "no point: end"),
                1 => write!(f, "one point: case I"),
                _ => write!(f, "two points: case II"),
            },
            Self::End => write!(f, "end"),
            Self::ReadSlope { p1, s1 } => write!(f, "read {} for {}", Named(["S1"], [*s1]), point("P1", *p1)),
            Self::CaseOne { curve: Ok(curve), .. } => write!(f, "compute {}", Named(JKLM, curve.jklm)),
            Self::CaseOne { curve: Err(refusal), .. } => write!(f, "case I: {refusal}"),
            Self::Cancel(note) => write!(f, "{note}"),
        }
    }
}
