//! A path in the characters of a terminal: braille, 2 by 4 dots a character.

use std::fmt;

use super::Path;

/// Most dots across and down.
const MOST: [usize; 2] = [120, 96];
/// Least dots across and down, so that a flat path has a picture, too.
const LEAST: usize = 4;

/// Shown, it is a picture of the path, both axes to the same scale so that a circle is round, with the ends of the
/// data beside it. Nothing for a path that stays where it is.
#[derive(Clone, Copy, Debug)]
pub struct Picture<'a>(pub &'a Path);

impl fmt::Display for Picture<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let strokes = self.0.strokes();
        let [x, y] = [0, 1].map(|axis| ends(strokes, axis));
        let scale = ((x[1] - x[0]) / (MOST[0] - 1) as f64).max((y[1] - y[0]) / (MOST[1] - 1) as f64);
        if scale <= 0.0 || !scale.is_finite() {
            return Ok(());
        }
        let dots = |ends: [f64; 2]| (((ends[1] - ends[0]) / scale).round() as usize + 1).max(LEAST);
        let mut canvas = Canvas::new(dots(x), dots(y));
        let place = |point: &[f64; 2]| [(point[0] - x[0]) / scale, (y[1] - point[1]) / scale];
        for stroke in strokes {
            let places: Vec<_> = stroke.iter().map(place).collect();
            places.windows(2).for_each(|ends| canvas.line(ends[0], ends[1]));
        }
        let lines = canvas.lines();
        let last = lines.len() - 1;
        for (row, line) in lines.iter().enumerate() {
            let label = match row {
                0 => format!(" {}", number(y[1])),
                _ if row == last => format!(" {}", number(y[0])),
                _ => String::new(),
            };
            let line = if label.is_empty() { line.trim_end_matches(BLANK) } else { line };
            writeln!(f, "{}{label}", line.replace(BLANK, " "))?;
        }
        let (left, right) = (number(x[0]), number(x[1]));
        let width = canvas.columns.saturating_sub(left.len()).max(right.len() + 1);
        writeln!(f, "{left}{right:>width$}\n")
    }
}

/// The least and the greatest coordinate on an axis.
fn ends(strokes: &[Vec<[f64; 2]>], axis: usize) -> [f64; 2] {
    let all = strokes.iter().flatten().map(|point| point[axis]);
    all.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], v| [low.min(v), high.max(v)])
}

/// A coordinate without a sign on zero.
fn number(value: f64) -> String {
    (value + 0.0).to_string()
}

/// Braille without a dot.
const BLANK: char = '\u{2800}';

/// Dots in rows of characters.
struct Canvas {
    columns: usize,
    cells: Vec<u8>,
}

impl Canvas {
    fn new(width: usize, height: usize) -> Self {
        let columns = width.div_ceil(2);
        Self { columns, cells: vec![0; columns * height.div_ceil(4)] }
    }

    fn dot(&mut self, x: usize, y: usize) {
        const BITS: [[u8; 2]; 4] = [[0x01, 0x08], [0x02, 0x10], [0x04, 0x20], [0x40, 0x80]];
        if let Some(cell) = self.cells.get_mut(y / 4 * self.columns + x / 2) {
            *cell |= BITS[y % 4][x % 2];
        }
    }

    fn line(&mut self, from: [f64; 2], to: [f64; 2]) {
        let span = [to[0] - from[0], to[1] - from[1]];
        let steps = span[0].abs().max(span[1].abs()).ceil().max(1.0);
        for step in 0..=steps as usize {
            let along = step as f64 / steps;
            let [x, y] = [0, 1].map(|axis| (from[axis] + span[axis] * along).round() as usize);
            self.dot(x, y);
        }
    }

    fn lines(&self) -> Vec<String> {
        let text =
            |row: &[u8]| row.iter().map(|&dots| char::from_u32(0x2800 + u32::from(dots)).unwrap_or(BLANK)).collect();
        self.cells.chunks(self.columns).map(text).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::{Signal, ValueId};
    use crate::trace::{Coordinate, Frame, Observer};

    fn picture(points: &[[i64; 2]]) -> String {
        let axes = ["x", "y"].map(|name| Coordinate::Signal(name.to_owned()));
        let signals: Vec<_> = (0..2)
            .map(|i| {
                let path = vec!["top".into(), ["x", "y"][i].into()];
                Signal { path, width: 64, signed: true, fraction: None, value: ValueId::new(i) }
            })
            .collect();
        let mut path = Path::new(axes, None);
        path.begin(&signals).expect("both are there");
        for (tick, point) in points.iter().enumerate() {
            let words = point.map(|v| v as u64);
            path.tick(Frame { tick: tick as u64 + 1, words: &words, before: None }).expect("nothing is written");
        }
        Picture(&path).to_string()
    }

    #[test]
    fn a_rectangle_has_four_sides_and_the_ends_of_the_data_beside_it() {
        let text = picture(&[[0, 0], [14, 0], [14, 14], [0, 14], [0, 0]]);
        let lines: Vec<_> = text.lines().collect();
        assert!(lines[0].starts_with('⡏') && lines[0].ends_with(" 14"), "{text}");
        assert!(lines[lines.len() - 3].ends_with(" 0"), "{text}");
        assert!(lines[lines.len() - 2].starts_with('0') && lines[lines.len() - 2].ends_with("14"), "{text}");
        assert!(text.lines().all(|line| line == line.trim_end()), "{text}");
    }

    #[test]
    fn a_flat_path_and_numbers_wider_than_the_picture_are_shown_and_a_point_is_not() {
        assert!(picture(&[[5, 7], [9, 7]]).contains("7\n5"));
        assert!(picture(&[[0, -1_000_000_000_000_000], [1, 1_000_000_000_000_000]]).contains("-1000000000000000"));
        assert_eq!(picture(&[[5, 7], [5, 7]]), "");
    }
}
