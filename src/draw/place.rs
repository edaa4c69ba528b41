//! Where a drawing goes: from millimetres to counts.

use kurbo::{Affine, BezPath, Rect, Shape as _, Vec2};

use crate::base::{Diagnostic, Report};

/// The largest coordinate in counts; one less than a word holds, so that a pulse too many is still seen.
const LARGEST: f64 = 32_766.0;

/// How large a drawing becomes.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Placement {
    /// Its longer side is so many counts.
    Size(f64),
    /// So many counts are a millimetre.
    CountsPerMillimetre(f64),
    /// As large as the machine's words allow.
    Fit,
}

/// Curves in counts.
#[derive(Clone, Debug)]
pub struct Sheet {
    /// One for each time the pen is put down.
    pub curves: Vec<BezPath>,
    /// Counts of a millimetre of the drawing.
    pub counts_per_millimetre: f64,
}

impl Placement {
    /// The curves in counts, their lower left corner at (0, 0); with [`Placement::Fit`] their middle is there.
    ///
    /// # Errors
    /// `D001` a size that is none, `D002` curves that leave the machine's words, `D003` nothing to draw.
    pub fn place(self, curves: &[BezPath]) -> Result<Sheet, Report> {
        let extent = curves.iter().map(BezPath::bounding_box).reduce(|one, other| one.union(other));
        let extent = extent.ok_or_else(|| {
            Diagnostic::new("D003", "there is nothing to draw: the file has no curve that can be seen")
        })?;
        let long = extent.width().max(extent.height());
        let scale = match self {
            Self::Size(size) => size / long,
            Self::CountsPerMillimetre(counts) => counts,
            Self::Fit => 2.0 * LARGEST / long,
        };
        if !(scale.is_finite() && scale > 0.0) {
            let diagnostic = Diagnostic::new("D001", "the drawing would have no size");
            return Err(diagnostic
                .help("--size and --counts-per-mm are more than 0, and a drawing has more than a point")
                .into());
        }
        let corner = if self == Self::Fit { extent.center() } else { extent.origin() };
        let to_counts = Affine::scale(scale) * Affine::translate(-corner.to_vec2());
        let placed: Rect = to_counts.transform_rect_bbox(extent);
        if [placed.x0, placed.y0, placed.x1, placed.y1].iter().any(|side| side.abs() > LARGEST * 1.000_001) {
            let Vec2 { x, y } = placed.size().to_vec2();
            let diagnostic = Diagnostic::new("D002", format!("{x:.0} by {y:.0} counts leave the machine's 16 bits"));
            return Err(diagnostic.help("draw it smaller, or with --fit, which takes all there is").into());
        }
        let curves = curves.iter().map(|curve| to_counts * curve).collect();
        Ok(Sheet { curves, counts_per_millimetre: scale })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn place(placement: Placement, ends: &[[f64; 2]]) -> Result<Rect, &'static str> {
        let mut curve = BezPath::new();
        ends.iter()
            .enumerate()
            .for_each(|(i, [x, y])| if i == 0 { curve.move_to((*x, *y)) } else { curve.line_to((*x, *y)) });
        let curves: Vec<_> = Some(curve).filter(|curve| !curve.is_empty()).into_iter().collect();
        placement
            .place(&curves)
            .map(|sheet| sheet.curves[0].bounding_box())
            .map_err(|report| report.diagnostics[0].code)
    }

    #[test]
    fn a_drawing_stands_at_the_origin_in_the_size_that_was_asked_for() {
        let line = [[10.0, -5.0], [30.0, 0.0]];
        assert_eq!(place(Placement::Size(4000.0), &line), Ok(Rect::new(0.0, 0.0, 4000.0, 1000.0)));
        assert_eq!(place(Placement::CountsPerMillimetre(8.0), &line), Ok(Rect::new(0.0, 0.0, 160.0, 40.0)));
        let fit = place(Placement::Fit, &line).expect("it fits");
        assert_eq!((fit.x0, fit.x1), (-LARGEST, LARGEST));
    }

    #[test]
    fn what_has_no_size_no_curve_or_no_room_is_refused() {
        let point = [[1.0, 1.0], [1.0, 1.0]];
        assert_eq!(place(Placement::Size(100.0), &point), Err("D001"));
        assert_eq!(place(Placement::CountsPerMillimetre(f64::NAN), &[[0.0, 0.0], [1.0, 1.0]]), Err("D001"));
        assert_eq!(place(Placement::Size(40_000.0), &[[0.0, 0.0], [1.0, 1.0]]), Err("D002"));
        assert_eq!(place(Placement::Fit, &[]), Err("D003"));
    }
}
