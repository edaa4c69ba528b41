//! Draws the sheet of docs/characters.svg: every character of FIG. 17 as its netlist draws it, tick by tick. Run it with
//! `cargo run --release --example character_sheet > docs/characters.svg`.

use stepwright::base::Report;
use stepwright::simulation::{Circuit, Run};
use stepwright::trace::Select;

const CIRCUIT: &str = "us3809868/fig17_characters";
/// Three guard stages: the steps of the path are those of the rounded curve, nearly.
const PARAMETERS: &[(&str, i64)] = &[("GUARD", 3)];
/// 1/8 of the enlarged scale, with 12 bits of fraction: capitals of 125 counts.
const SCALE: i64 = 4096 / 8;
const LINE: i64 = 215;

/// The lines of the sheet, in the codes of Windows-1251 and what letters.glyphs adds to it.
const LINES: &[&[u8]] = &[
    b"US 3,809,868  FIG. 17",
    b"ABCDEFGHIJKLMNOPQRSTUVWXYZ",
    b"abcdefghijklmnopqrstuvwxyz",
    b"0123456789 !\"#$%&'()*+,-./",
    b":;<=>?@[\\]^_`{|}~",
    b"\xC0\xC1\xC2\xC3\xC4\xC5\xA8\xC6\xC7\xC8\xC9\xCA\xCB\xCC\xCD\xCE\xCF",
    b"\xD0\xD1\xD2\xD3\xD4\xD5\xD6\xD7\xD8\xD9\xDA\xDB\xDC\xDD\xDE\xDF",
    b"\xE0\xE1\xE2\xE3\xE4\xE5\xB8\xE6\xE7\xE8\xE9\xEA\xEB\xEC\xED\xEE\xEF\xF0\xF1\xF2\xF3\xF4",
    b"\xF5\xF6\xF7\xF8\xF9\xFA\xFB\xFC\xFD\xFE\xFF",
    b"\x85 \x96 \x97 \xAB \xBB \xB0 \xB1 \xB5 \xB7 \xB9 \x98 \x18\x19\x1A\x1B\x1D",
    b"Sphinx of black quartz, 5 \xB5F",
    b"\xD1\xFA\xE5\xF8\xFC \xE5\xF9\xB8 \xFD\xF2\xE8\xF5 \xE1\xF3\xEB\xEE\xEA!",
];

fn main() -> Result<(), Report> {
    print!("{}", sheet()?);
    Ok(())
}

/// The sheet as SVG.
///
/// # Errors
/// What is wrong with the circuit or its glyphs.
pub fn sheet() -> Result<String, Report> {
    let session = PARAMETERS.iter().fold(Circuit::shipped(CIRCUIT)?.session(), |session, (name, value)| {
        session.parameter(name, *value).ticks(100_000_000)
    });
    let mut machine = session.observe(Select::new::<&str>([])?).start()?;
    let (mut paths, mut width) = (String::new(), 0);
    for (row, line) in (1..).zip(LINES) {
        let mut pen = [0, -LINE * row];
        for &code in *line {
            pen = draw(&mut machine, code, pen, &mut paths)?;
        }
        width = width.max(pen[0]);
    }
    let height = LINE * LINES.len() as i64 + 100;
    Ok(format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-40 -20 {} {}\">\n\
         <title>Characters of US 3,809,868, FIG. 17, drawn by the netlist {CIRCUIT}</title>\n\
         <desc>One unit is one count of X or Y; capitals are 125 counts high, lines 10 counts wide.\n\
         Made by cargo run --release --example character_sheet</desc>\n\
         <rect x=\"-40\" y=\"-20\" width=\"100%\" height=\"100%\" fill=\"white\"/>\n\
         <g transform=\"scale(1 -1)\" fill=\"none\" stroke=\"black\" stroke-width=\"10\" stroke-linecap=\"round\" \
         stroke-linejoin=\"round\">\n{paths}</g>\n</svg>\n",
        width + 80,
        height
    ))
}

/// Draws a character from `pen` on into `paths`; where the next one begins.
fn draw(machine: &mut Run, code: u8, pen: [i64; 2], paths: &mut String) -> Result<[i64; 2], Report> {
    let start = machine.input("start")?;
    for (name, value) in [("code_449", code.into()), ("x0", pen[0]), ("y0", pen[1]), ("scale_514", SCALE)] {
        let input = machine.input(name)?;
        machine.set(input, value)?;
    }
    machine.set(start, 1)?;
    machine.step(1);
    machine.set(start, 0)?;
    let [mark, done, error] = [machine.net("mark")?, machine.net("done")?, machine.net("error")?];
    let place = [machine.net("x")?, machine.net("y")?];
    let mut stroke = Vec::new();
    while machine.read(done) == 0 {
        if machine.read(mark) == 1 {
            stroke.push(place.map(|axis| machine.read(axis) as i64));
        } else {
            append(paths, &std::mem::take(&mut stroke));
        }
        machine.step(1);
    }
    assert_eq!(machine.read(error), 0, "character {code:02X}");
    Ok(place.map(|axis| machine.read(axis) as i64))
}

/// A stroke as a path: its steps, those in one direction as one.
fn append(paths: &mut String, stroke: &[[i64; 2]]) {
    let Some([x, y]) = stroke.first() else { return };
    paths.push_str(&format!("<path d=\"M{x} {y}"));
    let steps = stroke.windows(2).map(|pair| [pair[1][0] - pair[0][0], pair[1][1] - pair[0][1]]);
    let steps: Vec<_> = steps.filter(|step| *step != [0, 0]).collect();
    for run in steps.chunk_by(|a, b| a == b) {
        let [dx, dy] = run[0].map(|step| step * run.len() as i64);
        paths.push_str(&format!("l{dx} {dy}"));
    }
    paths.push_str("\"/>\n");
}
