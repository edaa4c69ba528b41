//! A chain: what FIG. 19 reads, and the linked strokes that it makes of it.

use super::{Curve, Flow, Note, Point, Step, Stroke};

/// What operation 598 reads.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Entry {
    /// Two points: the next section is one of case II.
    Two {
        /// The point between.
        p3: Point,
        /// The end.
        p1: Point,
    },
    /// One point: the next section is one of case I.
    One {
        /// The end.
        p1: Point,
        /// The slope there, which operation 604 reads.
        s1: f64,
    },
}

/// The slope that operation 596 carries from the end of a section to the begin of the next one.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum Carry {
    /// L/J, the slope of the end. Claim 31 asks for it: the "relative variations" at the terminal point.
    #[default]
    EndSlope,
    /// M/K, as the text prints it: that is the slope of the begin, and the chain has corners.
    AsPrinted,
}

/// Points and slopes of linked sections, in counts; as many as the memory holds.
#[derive(Clone, PartialEq, Debug)]
pub struct Chain {
    /// P0.
    pub(super) p0: Point,
    /// The slope at P0.
    pub(super) s0: f64,
    /// What 582 reads, then what 598 reads.
    pub(super) entries: Vec<Entry>,
    pub(super) carry: Carry,
}

impl Entry {
    /// How many points: 1 or 2.
    #[must_use]
    pub fn points(&self) -> usize {
        match self {
            Self::Two { .. } => 2,
            Self::One { .. } => 1,
        }
    }
}

impl Chain {
    /// A chain that begins at `p0` with the slope `s0`, without any section. FIG. 19 reads two points first; one that
    /// begins with a single point goes on at 604, and one without any at 602 (chosen).
    #[must_use]
    pub fn new(p0: Point, s0: f64) -> Self {
        Self { p0, s0, entries: Vec::new(), carry: Carry::EndSlope }
    }

    /// One section more.
    #[must_use]
    pub fn then(mut self, entry: Entry) -> Self {
        self.entries.push(entry);
        self
    }

    /// The same chain with another slope carried on.
    #[must_use]
    pub fn carrying(self, carry: Carry) -> Self {
        Self { carry, ..self }
    }

    /// The operations of FIG. 19, one by one.
    #[must_use]
    pub fn flow(&self) -> Flow<'_> {
        Flow::of(self)
    }

    /// All of them at once. What has no solution is cancelled, told in the notes, and the chain goes on from where it
    /// stood.
    #[must_use]
    pub fn link(&self) -> Linked {
        let mut linked = Linked::default();
        for step in self.flow() {
            match step {
                Step::Send { section, note } => {
                    linked.sections.push(section);
                    linked.notes.extend(note);
                }
                Step::Cancel(note) => linked.notes.push(note),
                _ => {}
            }
        }
        linked
    }
}

/// A section of a chain that has been accepted.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Section {
    /// 1 or 2.
    pub case: u8,
    /// The slope at its begin.
    pub s0: f64,
    /// In real numbers.
    pub curve: Curve,
    /// In the words of the registers.
    pub stroke: Stroke,
    /// P1.
    pub to: Point,
    /// The slope that is carried on.
    pub s1: f64,
}

/// What came of a chain.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Linked {
    /// The sections, each from where the one before ends.
    pub sections: Vec<Section>,
    /// What the operator should know, in order.
    pub notes: Vec<Note>,
}
