//! An SVG text, and the PNG that is made from it.

use std::path::Path;

use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree};

use super::fonts;
use crate::base::{Diagnostic, Report};
use crate::files;

/// Pixels of a PNG for each unit of its SVG, so that letters stay sharp on today's screens.
const PIXELS_A_UNIT: f32 = 2.0;
/// Most pixels along a side of a PNG: 8192 by 8192 take 256 MiB.
const MOST_PIXELS: f32 = 8192.0;

/// A picture as SVG text.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Svg(String);

impl Svg {
    /// The picture of an SVG text, whoever composed it. Its letters are those of the font that the program carries,
    /// whatever family it names.
    #[must_use]
    pub fn new(text: String) -> Self {
        Self(text)
    }

    /// The text.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.0
    }

    /// The picture as PNG, with two pixels for each unit of the SVG, on white. The same text gives the same bytes.
    ///
    /// # Errors
    /// `P001` the text is no SVG, or has more than 4096 units on a side.
    pub fn png(&self) -> Result<Vec<u8>, Report> {
        let options = Options { fontdb: fonts(), font_family: "DejaVu Sans".to_owned(), ..Options::default() };
        let tree =
            Tree::from_str(&self.0, &options).map_err(|error| wrong(&format!("no SVG was composed: {error}")))?;
        let [width, height] = [tree.size().width(), tree.size().height()].map(|side| (side * PIXELS_A_UNIT).ceil());
        let canvas = (width <= MOST_PIXELS && height <= MOST_PIXELS).then(|| Pixmap::new(width as u32, height as u32));
        let mut canvas = canvas.flatten().ok_or_else(|| {
            wrong(&format!("{width} by {height} pixels are too many")).help("write an SVG, which has no pixels")
        })?;
        canvas.fill(resvg::tiny_skia::Color::WHITE);
        resvg::render(&tree, Transform::from_scale(PIXELS_A_UNIT, PIXELS_A_UNIT), &mut canvas.as_mut());
        Ok(canvas.encode_png().map_err(|error| wrong(&error.to_string()))?)
    }

    /// Writes the picture to the files that are given. The PNG is made first: when it cannot be, no file is written.
    ///
    /// # Errors
    /// `P001`; `C003`, `C031` a file that cannot be written.
    pub fn write(&self, svg: Option<&Path>, png: Option<&Path>) -> Result<(), Report> {
        let pixels = png.map(|path| self.png().map(|pixels| (path, pixels))).transpose()?;
        if let Some(path) = svg {
            files::write_bytes(path, self.0.as_bytes())?;
        }
        pixels.map_or(Ok(()), |(path, pixels)| files::write_bytes(path, &pixels))
    }
}

/// `P001`.
fn wrong(why: &str) -> Diagnostic {
    Diagnostic::new("P001", format!("the picture cannot be made: {why}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn black(svg: &str) -> usize {
        let png = Svg::new(svg.to_owned()).png().expect("an SVG");
        let pixels = Pixmap::decode_png(&png).expect("a PNG");
        pixels.pixels().iter().filter(|pixel| pixel.red() < 128).count()
    }

    #[test]
    fn a_unit_becomes_two_pixels_on_white() {
        let square = "<svg xmlns='http://www.w3.org/2000/svg' width='9' height='7'><path d='M1 1h3v2h-3z'/></svg>";
        assert_eq!(black(square), 3 * 2 * 4);
        let png = Svg::new(square.to_owned()).png().expect("an SVG");
        let pixels = Pixmap::decode_png(&png).expect("a PNG");
        assert_eq!((pixels.width(), pixels.height()), (18, 14));
        assert_eq!(pixels.pixel(17, 13).map(|pixel| (pixel.red(), pixel.alpha())), Some((255, 255)));
    }

    #[test]
    fn letters_of_three_alphabets_are_drawn_in_whatever_family_is_named() {
        for text in ["A", "Ж", "Ω", "≤"] {
            let svg = |family| {
                format!(
                    "<svg xmlns='http://www.w3.org/2000/svg' width='40' height='40'>\
                     <text x='5' y='30' font-size='30' font-family='{family}'>{text}</text></svg>"
                )
            };
            let drawn = black(&svg(super::super::FONT));
            assert!(drawn > 50, "{text}: {drawn} pixels");
            assert_eq!(black(&svg("No Such Family")), drawn, "{text}");
        }
    }

    #[test]
    fn what_is_no_picture_or_too_large_is_refused_and_nothing_is_written() {
        let folder = tempfile::tempdir().expect("a folder");
        let [svg, png] = ["a.svg", "a.png"].map(|name| folder.path().join(name));
        for text in ["<svg", "<svg xmlns='http://www.w3.org/2000/svg' width='5000' height='1'/>"] {
            let report = Svg::new(text.to_owned()).write(Some(&svg), Some(&png)).expect_err("no picture");
            assert_eq!(report.diagnostics[0].code, "P001");
            assert!(!svg.exists() && !png.exists());
        }
    }
}
