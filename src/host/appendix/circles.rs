//! CIRCLE and SEMI; and CURSET, which is lost.

use super::{Message, Program, Type};
use crate::host::{Curve, Point};

impl Program<'_> {
    /// CIRCLE (XCTR, YCTR, RADIUS), lines 1600 to 1710, from its leftmost point on, clockwise.
    ///
    /// # Errors
    /// Those of [`Program::typcrv`].
    pub fn circle(&mut self, centre: Point, radius: f64) -> Result<Curve, Message> {
        let before = self.beg;
        let circle = Curve::circle(centre, radius);
        self.curset(circle.from); // 1620, 1630
        let drawn = self.typcrv(circle.jklm, Type::Whole); // 1640 to 1690
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
        self.typcrv(Curve::half_circle(self.beg, end, idirec == 1).jklm, Type::Half)
    }

    /// CURSET (X, Y), which is lost: the next stroke begins there. It puts no words into the buffer (chosen: what they
    /// were is lost, too).
    pub fn curset(&mut self, point: Point) {
        self.beg = point;
    }
}
