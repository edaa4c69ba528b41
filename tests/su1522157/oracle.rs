//! Equations (1) to (3) of the patent in exact whole numbers: everything in eighths of a step.

/// A step of the oracle, with F and R as they are after it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Row {
    pub combined: bool,
    pub f: i64,
    pub r: i64,
}

/// F0 of equation (2).
pub fn first_f(major: i64, minor: i64) -> i64 {
    // 8 * 0.5 * (0.75 (X - Y) - Y)
    3 * (major - minor) - 4 * minor
}

/// R before the first step.
pub fn first_r(major: i64) -> i64 {
    8 * major - 3
}

/// The steps of a frame.
pub fn rows(major: i64, minor: i64) -> Vec<Row> {
    let (mut f, mut r) = (first_f(major, minor), first_r(major));
    let mut rows = Vec::new();
    while r >= 0 {
        let combined = f < 0;
        (f, r) = if combined { (f + 6 * (major - minor), r - 6) } else { (f - 8 * minor, r - 8) };
        rows.push(Row { combined, f, r });
    }
    rows
}

/// The same as the vectors write them.
pub fn letters(major: i64, minor: i64) -> String {
    rows(major, minor).iter().map(|row| if row.combined { 'D' } else { 'U' }).collect()
}
