//! From the text of a glyph file to instruction sets, every mistake noted.

use super::line::{Word, lines};
use super::pen::{Pen, Point, position};
use super::{Glyphs, control};
use crate::base::{Diagnostic, SourceId, Span};

/// Words of memory 502: half of what an address reaches, so that an address and a count of words never overflow.
const MOST_WORDS: usize = 1 << 15;
/// Mistakes beyond which no more are looked for.
const MOST_ERRORS: usize = 100;

const STATEMENTS: [&str; 6] = ["glyph", "move", "line", "arc", "smooth", "advance"];

/// Reads a file.
pub(super) fn read(source: SourceId, text: &str) -> Result<Glyphs, Vec<Diagnostic>> {
    let mut reader = Reader {
        glyphs: Glyphs { words: Vec::new(), pointers: [None; 256] },
        codes: [None; 256],
        glyph: None,
        errors: Vec::new(),
    };
    for words in lines(source, text) {
        if reader.errors.len() >= MOST_ERRORS {
            break;
        }
        if let Err(error) = reader.statement(&words) {
            reader.errors.push(error);
            reader.glyph.iter_mut().for_each(|glyph| glyph.pen.lose());
        }
    }
    reader.finish_glyph();
    if reader.glyphs.words.len() > MOST_WORDS {
        let message = format!("the glyphs fill {} words; the memory holds {MOST_WORDS}", reader.glyphs.words.len());
        reader.errors.push(Diagnostic::new("G006", message));
    }
    if reader.errors.is_empty() { Ok(reader.glyphs) } else { Err(reader.errors) }
}

/// A glyph being read.
struct Glyph {
    span: Span,
    pen: Pen,
    is_finished: bool,
}

struct Reader {
    glyphs: Glyphs,
    /// Where each code has been given.
    codes: [Option<Span>; 256],
    glyph: Option<Glyph>,
    errors: Vec<Diagnostic>,
}

impl Reader {
    fn statement(&mut self, words: &[Word<'_>]) -> Result<(), Diagnostic> {
        let (first, rest) = (words[0], &words[1..]);
        match (first.text, rest) {
            ("glyph", _) => self.glyph(&first, rest)?,
            ("move", _) => {
                let to = point(&first, rest, "move X Y")?;
                self.drawing(&first)?.move_to(to);
                self.emit(&position(to));
            }
            ("advance", _) => {
                let [x] = numbers(&first, rest, "advance X")?;
                self.drawing(&first)?;
                self.glyph.iter_mut().for_each(|glyph| glyph.is_finished = true);
                self.emit(&position([x, 0]));
                self.emit(&[control::EXIT as u16]);
            }
            ("smooth", [stroke, rest @ ..]) => self.stroke(stroke, rest, true)?,
            ("smooth", []) => {
                return Err(first.wrong("G001", "`smooth` without its stroke", "`arc` or `line` follows it"));
            }
            _ => self.stroke(&first, rest, false)?,
        }
        Ok(())
    }

    fn stroke(&mut self, first: &Word<'_>, rest: &[Word<'_>], smooth: bool) -> Result<(), Diagnostic> {
        let words = match first.text {
            "line" => {
                let to = point(first, rest, "line X Y")?;
                self.drawing(first)?.line(first, smooth, to)?
            }
            "arc" => {
                let [qx, qy, x, y] = numbers(first, rest, "arc QX QY X Y")?;
                self.drawing(first)?.arc(first, smooth, [qx, qy], [x, y])?
            }
            strange => {
                let wrong = first.wrong("G001", format!("there is no statement `{strange}`"), "here");
                let wrong = wrong.nearest(strange, STATEMENTS);
                return Err(wrong.help(format!("a line begins with one of {}", STATEMENTS.join(", "))));
            }
        };
        self.emit(&words);
        Ok(())
    }

    /// `glyph CODE CHARACTER CODE CHARACTER ...`
    fn glyph(&mut self, first: &Word<'_>, rest: &[Word<'_>]) -> Result<(), Diagnostic> {
        self.finish_glyph();
        self.glyph = Some(Glyph { span: first.span, pen: Pen::default(), is_finished: false });
        if rest.is_empty() || rest.len() % 2 == 1 {
            let wrong = first.wrong("G001", "a glyph has pairs of a code and its character", "not in pairs");
            return Err(wrong.help("for example `glyph 41 A`, or `glyph 41 A C0 \u{410}` for two of one shape"));
        }
        for pair in rest.chunks(2) {
            let code = pair[0].code()?;
            let earlier = self.codes[usize::from(code)].replace(pair[0].span);
            if let Some(earlier) = earlier {
                let wrong = pair[0].wrong("G003", format!("two glyphs have the code {code:02X}"), "again here");
                self.errors.push(wrong.at(earlier, "first here"));
            }
            self.glyphs.pointers[usize::from(code)] = Some(self.glyphs.words.len() as u16);
        }
        Ok(())
    }

    /// Notes it when the glyph before has not been finished.
    fn finish_glyph(&mut self) {
        if let Some(glyph) = self.glyph.take().filter(|glyph| !glyph.is_finished) {
            let wrong = Diagnostic::new("G004", "a glyph without its `advance`").at(glyph.span, "begun here");
            self.errors.push(wrong.help("end it with `advance X`, where the next character begins"));
        }
    }

    /// The pen of the glyph that a statement belongs to.
    fn drawing(&mut self, statement: &Word<'_>) -> Result<&mut Pen, Diagnostic> {
        match &mut self.glyph {
            Some(glyph) if !glyph.is_finished => Ok(&mut glyph.pen),
            Some(_) => Err(statement.wrong("G004", "the glyph has been finished by its `advance`", "after its end")),
            None => Err(statement.wrong("G004", "a statement outside of any glyph", "no `glyph` before it")),
        }
    }

    fn emit(&mut self, words: &[u16]) {
        self.glyphs.words.extend_from_slice(words);
    }
}

fn point(first: &Word<'_>, rest: &[Word<'_>], usage: &str) -> Result<Point, Diagnostic> {
    numbers(first, rest, usage)
}

/// The numbers behind a statement, of which there must be just so many.
fn numbers<const N: usize>(first: &Word<'_>, rest: &[Word<'_>], usage: &str) -> Result<[i32; N], Diagnostic> {
    let rest: &[Word<'_>; N] = rest.try_into().map_err(|_| {
        let message = format!("`{}` has {N} numbers, not {}", first.text, rest.len());
        first.wrong("G001", message, "here").help(format!("write `{usage}`"))
    })?;
    let mut numbers = [0; N];
    for (number, word) in numbers.iter_mut().zip(rest) {
        *number = word.number()?;
    }
    Ok(numbers)
}
