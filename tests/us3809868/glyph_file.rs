//! The glyph file as the tests read it: outlines straight from the text, by the rules of docs/characters.md and the
//! equations of the patent, with nothing of the reader under test.

use std::f64::consts::FRAC_PI_2;

/// X and Y, in units of the enlarged scale.
pub type Point = [f64; 2];

/// A stroke that is to be drawn.
#[derive(Clone, Copy, Debug)]
pub struct Stroke {
    /// X0, Y0.
    pub from: Point,
    /// J, L.
    pub cosine: Point,
    /// K, M.
    pub sine: Point,
    /// Where it ends, as the file says.
    pub to: Point,
    /// Whether the file says that it goes on smoothly from the stroke before.
    pub smooth: bool,
    /// Whether a move comes before it.
    pub moved: bool,
}

impl Stroke {
    /// X = J (cos t - 1) + K sin t + X0, and Y likewise, at a fraction of the quarter turn.
    pub fn at(&self, fraction: f64) -> Point {
        let (sin, cos) = (fraction * FRAC_PI_2).sin_cos();
        [0, 1].map(|axis| self.cosine[axis] * (cos - 1.0) + self.sine[axis] * sin + self.from[axis])
    }
}

/// A glyph.
#[derive(Debug, Default)]
pub struct Glyph {
    /// Codes and characters that share it.
    pub codes: Vec<(u8, String)>,
    /// Its strokes in order.
    pub strokes: Vec<Stroke>,
    /// How far the next origin is.
    pub advance: f64,
}

/// The glyphs of a good file, in order.
pub fn glyphs(text: &str) -> Vec<Glyph> {
    let mut glyphs: Vec<Glyph> = Vec::new();
    let (mut pen, mut moved) = ([0.0; 2], true);
    for line in text.lines() {
        let mut words: Vec<&str> = line.split("//").next().expect("a part").split_whitespace().collect();
        if words.is_empty() {
            continue;
        }
        if words[0] == "glyph" {
            let code = |digits| u8::from_str_radix(digits, 16).expect("a code");
            let codes = words[1..].chunks(2).map(|pair| (code(pair[0]), pair[1].to_owned())).collect();
            glyphs.push(Glyph { codes, ..Glyph::default() });
            continue;
        }
        let smooth = words[0] == "smooth";
        words.drain(..usize::from(smooth));
        let numbers: Vec<f64> = words[1..].iter().map(|word| word.parse().expect("a number")).collect();
        let glyph = glyphs.last_mut().expect("a glyph");
        let difference = |a: &[f64], b: &[f64]| [a[0] - b[0], a[1] - b[1]];
        let (cosine, sine, to) = match (words[0], &numbers[..]) {
            ("move", [x, y]) => {
                (pen, moved) = ([*x, *y], true);
                continue;
            }
            ("advance", [x]) => {
                glyph.advance = *x;
                continue;
            }
            ("line", [x, y]) => ([0.0; 2], difference(&[*x, *y], &pen), [*x, *y]),
            ("arc", [qx, qy, x, y]) => {
                let corner = [*qx, *qy];
                (difference(&corner, &[*x, *y]), difference(&corner, &pen), [*x, *y])
            }
            other => panic!("{other:?}"),
        };
        glyph.strokes.push(Stroke { from: pen, cosine, sine, to, smooth, moved });
        (pen, moved) = (to, false);
    }
    glyphs
}

/// The shipped file.
pub fn shipped() -> Vec<Glyph> {
    glyphs(stepwright::simulation::shipped::text("us3809868/letters.glyphs").expect("the file is shipped"))
}
