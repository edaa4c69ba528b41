//! Every glyph of FIG. 17, drawn through the netlist, against its outline.

use std::collections::HashMap;

use rayon::prelude::*;

use super::glyph_file::{Glyph, Stroke, shipped};
use super::machine::{Machine, Parameters};

#[path = "../../examples/character_sheet.rs"]
#[expect(dead_code, reason = "its main function is not wanted here")]
mod character_sheet;

const CIRCUIT: &str = "us3809868/fig17_characters";
/// 11 bits reach the coefficients of a glyph at its full scale.
const FULL: Parameters = &[("WIDTH", 11), ("ENTRIES", 64), ("ENTRY_WIDTH", 6)];
/// Three guard stages: the path of the counters is within about a count of the stroke.
const FINE: Parameters = &[("GUARD", 3)];

/// What came of a character.
struct Drawn {
    /// Where the pen was in each tick in which a stroke was marked, stroke by stroke.
    strokes: Vec<Vec<[i64; 2]>>,
    /// Where it was when `done` was high.
    end: [i64; 2],
    error: bool,
}

fn draw(machine: &mut Machine, code: u8, from: [i64; 2], scale: i64) -> Drawn {
    machine.set(&[("code_449", code.into()), ("x0", from[0]), ("y0", from[1]), ("scale_514", scale), ("start", 1)]);
    machine.tick();
    machine.set(&[("start", 0)]);
    let [x, y, mark, done] = ["x", "y", "mark", "done"].map(|name| machine.find(name));
    let mut strokes: Vec<Vec<_>> = vec![Vec::new()];
    let mut ticks = 0;
    while machine.word(done) == 0 {
        match (machine.word(mark), strokes.last_mut()) {
            (1, Some(stroke)) => stroke.push([x, y].map(|place| machine.number(place))),
            (_, Some(stroke)) if !stroke.is_empty() => strokes.push(Vec::new()),
            _ => {}
        }
        machine.tick();
        ticks += 1;
        assert!(ticks < 1_000_000, "character {code:02X} does not end");
    }
    strokes.pop();
    Drawn { strokes, end: [x, y].map(|place| machine.number(place)), error: machine.get("error") == 1 }
}

/// The greatest distance, on either axis, of a drawn stroke from its curve at the same time.
fn deviation(drawn: &[[i64; 2]], stroke: &Stroke, from: [i64; 2], scale: f64) -> f64 {
    let distance = |(tick, place): (usize, &[i64; 2])| {
        let ideal = stroke.at(tick as f64 / drawn.len() as f64);
        let axis = |axis: usize| (place[axis] as f64 - from[axis] as f64 - scale * ideal[axis]).abs();
        axis(0).max(axis(1))
    };
    drawn.iter().enumerate().map(distance).fold(0.0, f64::max)
}

/// Draws each glyph, each of its codes; the greatest deviation of all.
fn survey(parameters: Parameters, scale: i64, from: [i64; 2], judge: impl Fn(&Glyph, &Drawn) + Sync) -> f64 {
    let glyphs = shipped();
    let worst = |glyph: &Glyph| {
        let mut machine = Machine::shipped(CIRCUIT, parameters);
        let mut worst = 0.0_f64;
        for (code, name) in &glyph.codes {
            let drawn = draw(&mut machine, *code, from, scale);
            assert!(!drawn.error, "{name}");
            assert_eq!(drawn.strokes.len(), glyph.strokes.len(), "strokes of {name}");
            let advance = (glyph.advance * scale as f64 / 4096.0).round() as i64;
            assert_eq!(drawn.end, [from[0] + advance, from[1]], "end of {name}");
            judge(glyph, &drawn);
            for (drawn, stroke) in drawn.strokes.iter().zip(&glyph.strokes) {
                worst = worst.max(deviation(drawn, stroke, from, scale as f64 / 4096.0));
            }
        }
        worst
    };
    let all: Vec<f64> = glyphs.par_iter().map(worst).collect();
    let worst = all.into_iter().fold(0.0, f64::max);
    println!("{} glyphs at {scale}/4096: deviation {worst:.2} counts", glyphs.len());
    worst
}

#[test]
fn at_full_scale_every_stroke_begins_and_ends_just_where_the_file_says() {
    let from = [-300, 4000];
    let worst = survey(FULL, 4096, from, |glyph, drawn| {
        for (drawn, stroke) in drawn.strokes.iter().zip(&glyph.strokes) {
            let place = |point: [f64; 2]| [0, 1].map(|axis| from[axis] + point[axis] as i64);
            assert_eq!(drawn.first(), Some(&place(stroke.from)), "{:?}", glyph.codes);
            assert_eq!(drawn.last(), Some(&place(stroke.to)), "{:?}", glyph.codes);
        }
    });
    // The bound of the reading for 11 bits: the jitter of both multipliers of each axis.
    assert!(worst <= 2.0 * (3.0 * 11.0 + 7.0) / 18.0 + 1.97 * 2.0 * 1000.0 / 2048.0, "{worst}");
}

#[test]
fn at_an_eighth_of_the_scale_every_glyph_is_where_its_outline_is() {
    let worst = survey(FINE, 512, [1000, -2000], |_, _| {});
    assert!(worst <= 4.0, "{worst}");
}

#[test]
fn a_negative_scale_turns_a_glyph_by_half_a_turn() {
    let mut machine = Machine::shipped(CIRCUIT, FULL);
    let [upright, turned] = [800, -800].map(|scale| draw(&mut machine, b'R', [0, 0], scale));
    let mirrored = |drawn: &Drawn| -> Vec<Vec<[i64; 2]>> {
        drawn.strokes.iter().map(|stroke| stroke.iter().map(|point| point.map(|x| -x)).collect()).collect()
    };
    assert_eq!(mirrored(&upright), turned.strokes);
}

#[test]
fn joints_are_smooth_where_the_file_says_so_and_corners_nowhere_else_but_there() {
    let (mut smooth, mut corners) = (0, 0);
    for glyph in shipped() {
        for pair in glyph.strokes.windows(2).filter(|pair| !pair[1].moved) {
            let heading = |stroke: &Stroke, from: f64, to: f64| {
                let [a, b] = [from, to].map(|fraction| stroke.at(fraction));
                (b[1] - a[1]).atan2(b[0] - a[0])
            };
            let (before, after) = (heading(&pair[0], 1.0 - 1e-7, 1.0), heading(&pair[1], 0.0, 1e-7));
            let jump = (after - before + std::f64::consts::PI).rem_euclid(std::f64::consts::TAU) - std::f64::consts::PI;
            let jump = jump.abs().to_degrees();
            assert_eq!(jump < 2.0, pair[1].smooth, "{:?}: {jump} degrees at {:?}", glyph.codes, pair[1].from);
            *(if pair[1].smooth { &mut smooth } else { &mut corners }) += 1;
        }
    }
    assert!(smooth > 250 && corners > 100, "{smooth} smooth joints, {corners} corners");
}

/// What Windows-1251 has at a code, as far as the file goes, and what the file adds to it.
fn character(code: u8) -> char {
    let above = [
        (0x18, '\u{2191}'),
        (0x19, '\u{2193}'),
        (0x1A, '\u{2192}'),
        (0x1B, '\u{2190}'),
        (0x1D, '\u{2194}'),
        (0x85, '\u{2026}'),
        (0x96, '\u{2013}'),
        (0x97, '\u{2014}'),
        (0x98, '\u{3A9}'),
        (0xA8, '\u{401}'),
        (0xAB, '\u{AB}'),
        (0xB0, '\u{B0}'),
        (0xB1, '\u{B1}'),
        (0xB5, '\u{B5}'),
        (0xB7, '\u{B7}'),
        (0xB8, '\u{451}'),
        (0xB9, '\u{2116}'),
        (0xBB, '\u{BB}'),
    ];
    match code {
        0x20..0x7F => char::from(code),
        0xC0.. => char::from_u32(0x410 + u32::from(code) - 0xC0).expect("a letter"),
        _ => above.iter().find(|(known, _)| *known == code).unwrap_or_else(|| panic!("code {code:02X}")).1,
    }
}

#[test]
fn every_code_has_the_character_that_its_encoding_says_and_none_that_is_wanted_is_missing() {
    let mut found = HashMap::new();
    for (code, name) in shipped().into_iter().flat_map(|glyph| glyph.codes) {
        let character = character(code);
        assert_eq!(name, if character == ' ' { "space".to_owned() } else { character.to_string() });
        assert_eq!(found.insert(character, code), None);
    }
    let ascii = (0x20..0x7F_u8).map(char::from);
    let cyrillic = ('\u{410}'..='\u{44F}').chain(['\u{401}', '\u{451}']);
    let symbols = "\u{B5}\u{B0}\u{3A9}\u{B1}\u{2190}\u{2191}\u{2192}\u{2193}".chars();
    for wanted in ascii.chain(cyrillic).chain(symbols) {
        assert!(found.contains_key(&wanted), "{wanted}");
    }
}

#[test]
fn the_sheet_in_the_documentation_is_what_the_netlist_draws() {
    let drawn = character_sheet::sheet().unwrap_or_else(|report| panic!("{report}"));
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/characters.svg");
    let kept = std::fs::read_to_string(path).expect("the sheet");
    assert!(drawn == kept, "cargo run --release --example character_sheet > docs/characters.svg, and look at it");
}
