//! The reading's vectors.

use serde_json::Value;

/// A file of vectors.
pub fn read(name: &str) -> Value {
    let path = format!("{}/tests/vectors/us3809868/{name}", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"));
    serde_json::from_str(&text).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// An entry as a whole number.
pub fn number(value: &Value) -> i64 {
    value.as_i64().unwrap_or_else(|| panic!("{value} is no whole number"))
}

/// An entry as whole numbers.
pub fn numbers(value: &Value) -> Vec<i64> {
    list(value).iter().map(number).collect()
}

/// An entry as a list.
pub fn list(value: &Value) -> &[Value] {
    value.as_array().unwrap_or_else(|| panic!("{value} is no list"))
}

/// An entry as a real number.
pub fn real(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

/// An entry as real numbers.
pub fn reals(value: &Value) -> Vec<f64> {
    list(value).iter().map(real).collect()
}
