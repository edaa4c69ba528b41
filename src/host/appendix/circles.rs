//! CIRCLE and SEMI; and CURSET, which is lost.

use super::{Message, Program, Type};
use crate::host::{Curve, Point};

impl Program<'_> {
    /// CIRCLE (XCTR, YCTR, RADIUS), lines 1600 to 1710, from its leftmost point on, clockwise.
    ///
    /// # Errors
    /// Those of [`Program::typcrv`].
    pub fn circle(&mut self, [xctr, yctr]: Point, radius: f64) -> Result<Curve, Message> {
        let before = self.beg;
        self.curset([xctr - radius, yctr]); // 1620, 1630
        let drawn = self.typcrv([-radius, 0.0, 0.0, radius], Type::Whole); // 1640 to 1690
        if drawn.is_err() {
            self.beg = before;
        }
        drawn
    }

    /// SEMI (XEND, YEND, IDIREC), lines 1900 to 1940, after which the listing is lost. A half ellipse from XBEG, YBEG
    /// ends at (XBEG - 2 J, YBEG - 2 L), so that J = -A, L = -B; a half circle needs (K, M) = (B, -A) or (-B, A). Which
    /// of them is IDIREC = 1 is lost: the first one, counter-clockwise (chosen).
    ///
    /// # Errors
    /// Those of [`Program::typcrv`].
    pub fn semi(&mut self, end: Point, idirec: i16) -> Result<Curve, Message> {
        let [a, b] = [0, 1].map(|axis| (end[axis] - self.beg[axis]) / 2.0); // 1920, 1930
        let way = if idirec == 1 { 1.0 } else { -1.0 }; // 1940
        self.typcrv([-a, way * b, -b, -way * a], Type::Half)
    }

    /// CURSET (X, Y), which is lost: the next stroke begins there. It puts no words into the buffer (chosen: what they
    /// were is lost, too).
    pub fn curset(&mut self, point: Point) {
        self.beg = point;
    }
}
