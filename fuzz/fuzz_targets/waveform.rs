//! What must hold of any bytes that are read as a waveform.

use stepwright::golden::{How, Input, Names, Signals, compare, diff, read};

/// A file that is read equals itself, as a whole and time by time, whatever its names are matched by.
pub fn check(bytes: &[u8]) {
    let Ok(wave) = read("fuzzed", bytes) else { return };
    let whole = compare(&wave, &wave, Signals::All);
    assert_eq!(whole.divergence, None);
    let input = Input::bytes("fuzzed", bytes);
    for names in [Names::Same, Names::Tails(Vec::new())] {
        let how = How { names, ..How::default() };
        let streamed = diff(&input, &input, &how).expect("it has been read before");
        assert_eq!(streamed.is_equal(), whole.is_equal());
        assert_eq!(streamed.divergence, None);
    }
}
