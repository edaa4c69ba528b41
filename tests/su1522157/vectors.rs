//! The frames of `frames.json`: step for step, by digest, for either way of ending the carry ring.

use serde_json::Value;
use sha2::{Digest, Sha256};

use super::machine::{Machine, end_of, letters};

fn frames() -> Vec<Value> {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/vectors/su1522157/frames.json");
    let text = std::fs::read_to_string(path).expect("the vectors");
    let file: Value = serde_json::from_str(&text).expect("JSON");
    let frames = file["frames"].as_array().expect("a list of frames").clone();
    assert_eq!(frames.len(), 120, "a frame was lost");
    frames
}

fn number(frame: &Value, key: &str) -> i64 {
    frame[key].as_i64().unwrap_or_else(|| panic!("{key} in {frame}"))
}

fn digest(letters: &str) -> String {
    Sha256::digest(letters).iter().map(|byte| format!("{byte:02x}")).collect()
}

fn check_all(minus_zero: i64, column: &str) {
    let mut machine = Machine::new(&[("MINUS_ZERO", minus_zero)]);
    for frame in frames() {
        let (major, minor) = (number(&frame, "major"), number(&frame, "minor"));
        let steps = machine.frame(major, minor, true);
        let letters = letters(&steps);
        assert_eq!(letters.matches('U').count() as i64, number(&frame, "units"), "({major}, {minor})");
        assert_eq!(letters.matches('D').count() as i64, number(&frame, "combined"), "({major}, {minor})");
        let end = frame["end_quarters"].as_array().expect("an end point");
        assert_eq!(end_of(&steps), (end[0].as_i64().unwrap(), end[1].as_i64().unwrap()), "({major}, {minor})");
        assert_eq!(digest(&letters), frame[column].as_str().unwrap(), "({major}, {minor})");
        if let (0, Some(written_out)) = (minus_zero, frame["steps"].as_str()) {
            assert_eq!(letters, written_out, "({major}, {minor})");
        }
    }
}

#[test]
fn every_frame_is_stepped_as_the_vectors_say() {
    check_all(0, "sha256");
}

#[test]
fn every_frame_is_stepped_as_the_vectors_say_with_minus_zero() {
    check_all(1, "minus_zero_sha256");
}
