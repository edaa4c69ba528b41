//! The pen of a glyph: where it is, where it was going, and the words that its strokes become.

use super::control;
use super::line::Word;
use crate::base::Diagnostic;

/// X and Y.
pub(super) type Point = [i32; 2];

/// The pen between two statements of a glyph.
#[derive(Default)]
pub(super) struct Pen {
    /// Where it is; `None` before the first move.
    place: Option<Point>,
    /// Whether a mistake has left it nobody knows where: until the next move only numbers are judged.
    is_lost: bool,
    /// The direction in which the last stroke came to that place; `None` after a move.
    heading: Option<Point>,
}

/// The instruction of a positioning move.
pub(super) fn position([x, y]: Point) -> [u16; 3] {
    [control::POSITION as u16, x as u16, y as u16]
}

impl Pen {
    pub(super) fn move_to(&mut self, place: Point) {
        *self = Pen { place: Some(place), ..Pen::default() };
    }

    /// After a mistake.
    pub(super) fn lose(&mut self) {
        *self = Pen { place: Some([0, 0]), is_lost: true, ..Pen::default() };
    }

    /// A straight line.
    pub(super) fn line(&mut self, word: &Word<'_>, smooth: bool, to: Point) -> Result<[u16; 5], Diagnostic> {
        let way = way(self.start(word)?, to);
        self.stroke(word, smooth, [[0, 0], way], to, [way, way])
    }

    /// A quarter of an ellipse towards one point on to another.
    pub(super) fn arc(
        &mut self,
        word: &Word<'_>,
        smooth: bool,
        towards: Point,
        to: Point,
    ) -> Result<[u16; 5], Diagnostic> {
        let (first, last) = (way(self.start(word)?, towards), way(towards, to));
        self.stroke(word, smooth, [way(to, towards), first], to, [first, last])
    }

    fn start(&self, word: &Word<'_>) -> Result<Point, Diagnostic> {
        self.place.ok_or_else(|| {
            let wrong = word.wrong("G004", "a stroke that begins nowhere", "no `move` before it");
            wrong.help("begin the glyph with `move X Y`")
        })
    }

    /// The instruction of a stroke (J, L), (K, M) to `to`, which leaves and comes in these directions.
    fn stroke(
        &mut self,
        word: &Word<'_>,
        smooth: bool,
        [[j, l], [k, m]]: [Point; 2],
        to: Point,
        [leaves, comes]: [Point; 2],
    ) -> Result<[u16; 5], Diagnostic> {
        let before = self.heading.replace(comes);
        self.place = Some(to);
        let words = [control::CURVE as u16, j as u16, k as u16, l as u16, m as u16];
        if self.is_lost {
            return Ok(words);
        }
        if [leaves, comes].contains(&[0, 0]) {
            let wrong = word.wrong("G005", "a stroke of no length", "two of its points are the same");
            return Err(wrong.help("for an arc the point it heads for is neither its start nor its end"));
        }
        if smooth {
            check_joint(word, before, leaves)?;
        }
        Ok(words)
    }
}

fn way(from: Point, to: Point) -> Point {
    [to[0] - from[0], to[1] - from[1]]
}

/// Least turn, in degrees, at which a joint is no longer smooth.
const TURN: f64 = 2.0;

fn check_joint(word: &Word<'_>, before: Option<Point>, leaves: Point) -> Result<(), Diagnostic> {
    let Some(before) = before else {
        let wrong = word.wrong("G004", "a joint with nothing before it", "the first stroke after a move");
        return Err(wrong.help("leave `smooth` out: it says how a stroke joins the one before"));
    };
    let [[ax, ay], [bx, by]] = [before, leaves].map(|way| way.map(f64::from));
    let turn = (ax * by - ay * bx).atan2(ax * bx + ay * by).to_degrees();
    if turn.abs() < TURN {
        return Ok(());
    }
    let wrong = word.wrong("G005", format!("this joint is not smooth: the pen turns by {turn:.1} degrees"), "here");
    let help = format!(
        "the stroke before comes by ({ax}, {ay}), this one leaves by ({bx}, {by}); less than {TURN} degrees is smooth"
    );
    Err(wrong.help(help))
}
