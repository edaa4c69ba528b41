//! CRV22, CRV3B, CRV3, CRV3E, CRVMAX: cases I, II, IV, III and V. Each draws from XBEG, YBEG.

use super::{Listing, Message, Program, Type};
use crate::host::{Case, Curve, Point};

impl Program<'_> {
    /// CRV22 (XEND, YEND, SBEG, SEND), lines 100 to 240: slopes at both ends.
    ///
    /// # Errors
    /// [`Message::EqualSlopes`]; those of [`Program::typcrv`].
    pub fn crv22(&mut self, end: Point, sbeg: f64, send: f64) -> Result<Curve, Message> {
        if sbeg == send {
            return Err(Message::EqualSlopes); // 120
        }
        let [a, b] = less(end, self.beg); // 130, 140
        let aj = (a * sbeg - b) / (send - sbeg); // 150
        let al = send * aj; // 170
        self.typcrv([aj, a + aj, al, b + al], Type::Quarter) // 160, 180
    }

    /// CRV3B (XINTER, YINTER, XEND, YEND, SBEG), lines 400 to 580: a point between, and the slope at the begin.
    ///
    /// # Errors
    /// [`Message::InflectionAtBegin`]; those of [`Program::typcrv`].
    pub fn crv3b(&mut self, inter: Point, end: Point, sbeg: f64) -> Result<Curve, Message> {
        let ([a, b], [c, d]) = (less(end, self.beg), less(end, inter)); // 420 to 450
        let ratio = self.over(sbeg * c - d, sbeg * a - b)?;
        let (e, f) = self.e_and_f(ratio).ok_or(Message::InflectionAtBegin)?;
        let ak = (a * e - c) / (e + f - 1.0); // 490
        let am = sbeg * ak; // 510
        self.typcrv([ak - a, ak, am - b, am], Type::Quarter) // 500, 520
    }

    /// CRV3E (XINTER, YINTER, XEND, YEND, SEND), lines 1100 to 1280: a point between, and the slope at the end.
    ///
    /// # Errors
    /// [`Message::InflectionAtEnd`]; those of [`Program::typcrv`].
    pub fn crv3e(&mut self, inter: Point, end: Point, send: f64) -> Result<Curve, Message> {
        let ([a, b], [c, d]) = (less(end, self.beg), less(inter, self.beg)); // 1120 to 1150
        let ratio = self.over(send * c - d, send * a - b)?;
        let (e, f) = self.e_and_f(ratio).ok_or(Message::InflectionAtEnd)?;
        let ak = (a * f - (end[0] - inter[0])) / (e + f - 1.0); // 1190
        let aj = ak - a; // 1200
        let al = send * aj; // 1210
        self.typcrv([aj, ak, al, al + b], Type::Quarter) // 1220
    }

    /// Lines 460 to 480, and 1160 (lost, the same by symmetry) to 1180. As printed E is still a square where 490 and
    /// 1190 need the cosine or sine itself, so that the curve misses the point between; and a negative ratio passes.
    /// Corrected, E is tested before it is squared, and the root is taken of it (where 485 and 1185 would be).
    fn e_and_f(&self, ratio: f64) -> Option<(f64, f64)> {
        let e = ratio * ratio; // 460
        let f = (1.0 - e).sqrt(); // 480
        let (is_good, e) = match self.listing {
            Listing::AsPrinted => (e <= 1.0 || e.is_nan(), e), // 470: not .GT. 1
            Listing::Corrected => (ratio > 0.0 && ratio < 1.0, e.sqrt()),
        };
        is_good.then_some((e, f))
    }

    /// CRV3 (XINTER, YINTER, XEND, YEND, SINTER), lines 700 to 930: a point between, and the slope there. DP is G.
    ///
    /// # Errors
    /// [`Message::RoutineCrv3`]; those of [`Program::typcrv`].
    pub fn crv3(&mut self, inter: Point, end: Point, sinter: f64) -> Result<Curve, Message> {
        let ([a, b], [c, d]) = (less(end, self.beg), less(inter, self.beg)); // 720 to 750
        let [ap, bp, cp] = [end, inter, self.beg].map(|[x, y]| y - sinter * x); // 770 to 790
        let dp = self.over(cp - bp, ap - bp)?; // 800
        let is_bad = match self.listing {
            Listing::AsPrinted => dp < 0.0, // 810
            // The tangent runs through an end: 840 would divide by 0, or 800 has.
            Listing::Corrected => !(dp > 0.0 && dp.is_finite()),
        };
        if is_bad {
            return Err(Message::RoutineCrv3);
        }
        let e = (1.0 - dp + dp * (2.0 * dp).sqrt()) / (dp * dp + 1.0); // 820
        let f = (1.0 - e * e).sqrt(); // 830
        let [aj, al] = [(c, a), (d, b)].map(|(inter, end)| (inter - end * f) / (e + f - 1.0)); // 840, 850
        self.typcrv([aj, aj + a, al, al + b], Type::Quarter) // 860, 870
    }

    /// CRVMAX (XMAX, YMAX, XEND, YEND), lines 1400 to 1450: the point farthest from the chord, by CRV3 with the slope
    /// of the chord. Corrected, a vertical chord, which has none, is drawn by case V itself.
    ///
    /// # Errors
    /// Those of [`Program::crv3`].
    pub fn crvmax(&mut self, max: Point, end: Point) -> Result<Curve, Message> {
        let [a, b] = less(end, self.beg);
        if self.listing == Listing::Corrected && a == 0.0 {
            let curve = Case::V { p2: max }.curve(self.beg, end).map_err(|_| Message::RoutineCrv3)?;
            return self.typcrv(curve.jklm, Type::Quarter);
        }
        let sinter = self.over(b, a)?; // 1420
        self.crv3(max, end, sinter) // 1430
    }

    /// A quotient that stops the program when it divides by 0; corrected, it gets to the test that refuses it.
    fn over(&self, above: f64, below: f64) -> Result<f64, Message> {
        if self.listing == Listing::AsPrinted && below == 0.0 {
            Err(Message::DivisionByZero)
        } else {
            Ok(above / below)
        }
    }
}

fn less(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1]]
}
