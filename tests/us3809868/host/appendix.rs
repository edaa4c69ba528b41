//! Appendix A against the reading's vectors, and the buffer.

use std::cell::RefCell;

use serde_json::Value;
use stepwright::host::appendix::{Listing, Message, Program, Type, xtract};
use stepwright::host::{Curve, Point};

use super::{assert_near, point};
use crate::us3809868::vectors::{list, read, reals};

fn corrected() -> Program<'static> {
    let mut program = Program::new(Listing::Corrected, Box::new(|_| {}));
    program.init(1);
    program
}

fn call(program: &mut Program, call: &Value) -> Result<Curve, Message> {
    let arguments = reals(&call["args"]);
    let pair = |at: usize| -> Point { [arguments[at], arguments[at + 1]] };
    match call["call"].as_str().expect("a routine") {
        "CRV22" => program.crv22(pair(0), arguments[2], arguments[3]),
        "CRV3B" => program.crv3b(pair(0), pair(2), arguments[4]),
        "CRV3E" => program.crv3e(pair(0), pair(2), arguments[4]),
        "CRV3" => program.crv3(pair(0), pair(2), arguments[4]),
        "CRVMAX" => program.crvmax(pair(0), pair(2)),
        "CIRCLE" => program.circle(pair(0), arguments[2]),
        "SEMI" => program.semi(pair(0), arguments[2] as i16),
        other => panic!("no routine {other}"),
    }
}

#[test]
fn the_calls_of_the_vectors_give_their_strokes_and_the_same_words_in_the_buffer() {
    let file = read("fortran.json");
    let mut program = corrected();
    for entry in list(&file["calls"]) {
        assert_near(&program.beg(), &point(&entry["XBEG_YBEG_before"]), &entry.to_string());
        let words = program.words().len();
        match (call(&mut program, entry), entry["returns"].as_str()) {
            (Err(message), Some(printed)) => {
                assert_eq!(message.to_string(), printed);
                assert_eq!(program.words().len(), words, "an error leaves no words");
            }
            (Ok(curve), None) => {
                assert_near(&curve.jklm, &reals(&entry["returns"]), &entry.to_string());
                let drawn: Vec<_> = program.words()[words..].iter().map(|word| xtract(*word)).collect();
                assert_eq!(drawn, reals(&entry["rounded"]), "{entry}");
            }
            (got, _) => panic!("{entry}: {got:?}"),
        }
        assert_near(&program.beg(), &point(&entry["XBEG_YBEG_after"]), &entry.to_string());
    }
    let octal = |word: &Value| u16::from_str_radix(&word.as_str().expect("text")[2..], 8).expect("octal digits");
    let wanted = file["NBUFF_octal"].as_object().expect("words");
    let wanted: Vec<_> = (1..=wanted.len()).map(|at| octal(&wanted[&at.to_string()])).collect();
    assert_eq!(program.words(), wanted);
}

#[test]
fn a_word_is_eighths_in_two_s_complement_and_comes_back_whatever_its_flag() {
    let mut program = corrected();
    for eighths in -64..64_i32 {
        for flag in [false, true] {
            let value = f64::from(eighths) / 8.0;
            program.shtfmt(value, flag).expect("it fits");
            let word = *program.words().last().expect("a word");
            assert_eq!((xtract(word), word >= 128), (value, flag));
            // By the octal digits: 7-bit two's complement is the number and 200 octal together.
            assert_eq!(i32::from(word & 0o177), (eighths + 0o200) % 0o200);
        }
    }
}

#[test]
fn the_buffer_begins_with_its_head_and_goes_out_when_a_stroke_might_not_find_room() {
    let sent = RefCell::new(Vec::new());
    let mut program =
        Program::new(Listing::Corrected, Box::new(|words: &[u16]| sent.borrow_mut().push(words.to_vec())));
    program.init(3);
    let head = [0o202, 0o233, 0o300, 0o300, 0o301, 0o230, 0o301, 0o266, 0, 3 * 8, 0o300, 0o234];
    assert_eq!(program.words()[..12], head);
    assert_eq!(program.words()[12..], [0, 0, 0, 0, 0o300, 0o236]);
    // 1000 words less 18 of the head hold 245 strokes. JPTR is 999 then, and 1000 - 999 is below 4.
    for _ in 0..245 {
        program.typcrv([1.0, 0.0, 0.0, 1.0], Type::Whole).expect("it fits");
    }
    assert_eq!((sent.borrow().len(), program.words().len()), (0, 998));
    program.typcrv([2.0, 0.0, 0.0, 2.0], Type::Whole).expect("it fits");
    assert_eq!((sent.borrow().len(), sent.borrow()[0].len()), (1, 998));
    assert_eq!(program.words()[18..], [0o220, 0, 0o200, 0o220]);
    program.output();
    assert_eq!(sent.borrow()[1].len(), 22);
}

#[test]
fn single_words_find_room_as_well() {
    let mut program = corrected();
    for _ in 0..5000 {
        program.shtfmt(1.0, false).expect("it fits");
    }
    assert!(program.words().len() <= 1000);
}

#[test]
fn each_type_ends_where_its_ellipse_does() {
    for (itype, flags, end) in [
        (Type::Quarter, [128, 0, 0, 0], [3.0, -1.0]),
        (Type::Half, [128, 0, 0, 128], [2.0, 4.0]),
        (Type::ThreeQuarters, [128, 0, 128, 0], [-1.0, 5.0]),
        (Type::Whole, [128, 0, 128, 128], [0.0, 0.0]),
    ] {
        let mut program = corrected();
        // -J+K, -2J, -J-K, 0 with J = -1, K = 2, L = -2, M = -3 in units; the words hold eighths.
        program.typcrv([-1.0, 2.0, -2.0, -3.0], itype).expect("it fits");
        let [j, k, l, m] = [0o170, 16, 0o160, 0o150];
        let words: Vec<u16> = [j, k, l, m].into_iter().zip(flags).map(|(word, flag)| word + flag).collect();
        assert_eq!((&program.words()[18..], program.beg()), (&words[..], end), "{itype:?}");
    }
}

#[test]
fn a_semicircle_turns_either_way_and_stays_on_its_circle() {
    for (idirec, lowest) in [(1, -5.0), (2, 5.0)] {
        let mut program = corrected();
        let curve = program.semi([6.0, 8.0], idirec).expect("it fits");
        assert_eq!(program.beg(), [6.0, 8.0]);
        for step in 0..=8 {
            let [x, y] = curve.at(std::f64::consts::PI * f64::from(step) / 8.0);
            assert!(((x - 3.0).hypot(y - 4.0) - 5.0).abs() < 1e-12, "{x}, {y}");
        }
        // Half way it is beside the chord: to its right when the way is counter-clockwise.
        let [x, y] = curve.at(std::f64::consts::FRAC_PI_2);
        let right = (x - 3.0) * 0.8 - (y - 4.0) * 0.6;
        assert!((right + lowest).abs() < 1e-12, "{right}");
    }
}
