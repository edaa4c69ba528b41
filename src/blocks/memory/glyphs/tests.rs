//! What glyph files say, and how they are refused.

use crate::base::{Report, Sources};

use super::*;

/// What is wrong with a text, as it is shown.
fn refusal(text: &str) -> String {
    let mut sources = Sources::default();
    let source = sources.add("x.glyphs", text);
    let errors = instructions(source, text).expect_err("refused");
    Report::new(sources, errors).render(false)
}

/// Code and place of everything that is wrong.
fn places(text: &str) -> Vec<(&'static str, String)> {
    let mut sources = Sources::default();
    let source = sources.add("x", text);
    let errors = instructions(source, text).expect_err("refused");
    let place = |error: &Diagnostic| error.labels.first().map_or(String::new(), |(span, _)| sources.place(*span));
    errors.iter().map(|error| (error.code, place(error))).collect()
}

#[test]
fn an_arc_is_the_quarter_ellipse_between_its_tangents_and_a_line_is_a_sine_stroke() {
    let text = "// D\nglyph 44 D // the letter\n move 0 0\n line 0 1000\n line 250 1000\n smooth arc 600 1000 600 500\n advance 800\n";
    let words = instructions(SourceId::new(0), text).expect("a good file");
    let words: Vec<i16> = words.words().iter().map(|&word| word as i16).collect();
    let expected = [2, 0, 0, 1, 0, 0, 0, 1000, 1, 0, 250, 0, 0, 1, 0, 350, 500, 0, 2, 800, 0, 3];
    assert_eq!(words, expected);
}

#[test]
fn every_mistake_has_its_code_and_place_and_all_are_told_at_once() {
    let cases = [
        ("move 1 2", &[("G004", "x:1:1")][..]),
        ("glyph 41 A\n line 1 2\n advance 5", &[("G004", "x:2:2")]),
        ("glyph 41 A\n move 0 0\n smooth line 1 2\n advance 5", &[("G004", "x:3:9")]),
        ("glyph 41 A\n move 0 0", &[("G004", "x:1:1")]),
        ("glyph 41 A\nglyph 42 B\n advance 2\n line 0 0", &[("G004", "x:1:1"), ("G004", "x:4:2")]),
        ("glyph 41\n advance 1", &[("G001", "x:1:1")]),
        ("glyph\n advance 1", &[("G001", "x:1:1")]),
        ("glyph 4 A\n advance 1", &[("G003", "x:1:7")]),
        ("glyph +4 A\n advance 1", &[("G003", "x:1:7")]),
        ("glyph 41 A 41 B\n advance 1", &[("G003", "x:1:12")]),
        (
            "glyph 41 A\n curve 1 2\n smooth\n smooth move 1 2\n advance 1",
            &[("G001", "x:2:2"), ("G001", "x:3:2"), ("G001", "x:4:9")],
        ),
        (
            "glyph 41 A\n move 1\n move 1 2 3\n advance",
            &[("G001", "x:2:2"), ("G001", "x:3:2"), ("G001", "x:4:2"), ("G004", "x:1:1")],
        ),
        ("glyph 41 A\n move 1.5 16001\n move 0 --3\n advance 16000", &[("G002", "x:2:7"), ("G002", "x:3:9")]),
        (
            "glyph 41 A\n move 5 5\n line 5 5\n move 0 0\n arc 0 0 1 1\n move 0 0\n arc 1 1 1 1\n advance 1",
            &[("G005", "x:3:2"), ("G005", "x:5:2"), ("G005", "x:7:2")],
        ),
    ];
    for (text, expected) in cases {
        let expected: Vec<_> = expected.iter().map(|(code, place)| (*code, (*place).to_owned())).collect();
        assert_eq!(places(text), expected, "{text}");
    }
}

#[test]
fn a_joint_is_smooth_below_two_degrees_and_a_cusp_never_is() {
    let joint = |x: i32, y: i32| format!("glyph 41 A\n move 0 0\n line 1000 0\n smooth line {x} {y}\n advance 1");
    // 34/1000 is a turn of 1.95 degrees, 36/1000 of 2.06.
    assert!(instructions(SourceId::new(0), &joint(2000, 34)).is_ok());
    assert!(instructions(SourceId::new(0), &joint(2000, -34)).is_ok());
    assert!(refusal(&joint(2000, 36)).contains("the pen turns by 2.1 degrees"));
    assert!(refusal(&joint(0, 0)).contains("the pen turns by 180.0 degrees"));
}

#[test]
fn after_a_mistake_nothing_is_told_that_only_follows_from_it() {
    let text = "glyph 41 A\n move 0 x\n smooth line 0 0\n line 0 0\n move 3 3\n line 3 3\n advance 5";
    assert_eq!(places(text), [("G002", "x:2:9".to_owned()), ("G005", "x:6:2".to_owned())]);
}

#[test]
fn a_mistake_is_shown_with_its_line_and_how_to_mend_it() {
    let shown = refusal("glyph 41 A\n mvoe 1 2\n advance 5");
    for part in ["error[G001]: there is no statement `mvoe`", "x.glyphs:2:2", "did you mean `move`?"] {
        assert!(shown.contains(part), "{shown}");
    }
}

#[test]
fn the_memory_is_filled_to_its_last_word_and_no_further() {
    // 32768 words: 10922 moves of three, an exit and its position of four leave none.
    let text = |moves: usize| format!("glyph 41 A\n{}advance 1", "move 0 0\n".repeat(moves));
    let full = instructions(SourceId::new(0), &text(10_921)).expect("32767 words fit");
    assert_eq!(full.depth(), 32_767);
    assert_eq!(places(&text(10_922)), [("G006", String::new())]);
}

#[test]
fn thousands_of_mistakes_are_cut_short() {
    assert!(places(&"what\n".repeat(100_000)).len() <= 101);
}

#[test]
fn text_that_is_no_glyph_file_is_refused_and_an_empty_one_holds_no_character() {
    for text in ["\u{0}\u{1}", "\u{feff}glyph 41 A", "glyph 41 A\u{2028}advance 5", "{\"a\": 1}"] {
        assert!(!places(text).is_empty(), "{text:?}");
    }
    assert_eq!(instructions(SourceId::new(0), "// nothing\n").expect("an empty file").depth(), 0);
}
