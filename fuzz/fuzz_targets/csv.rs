//! Any bytes as the stimuli of `sweep --from`.
#![no_main]

use std::io::{Seek, Write};
use std::sync::LazyLock;

use libfuzzer_sys::{Corpus, fuzz_target};
use stepwright::cli::Stimuli;
use stepwright::simulation::{Circuit, Design};

const CIRCUIT: &str = "
module swept (
    input wire clk,
    input wire go,
    input wire [7:0] word,
    input wire signed [3:0] step,
    (* fraction = 3 *) input wire signed [5:0] slope,
    input wire [63:0] wide,
    output wire y
);
    and and_1 (y, go, word[0], step[0], slope[0], wide[0]);
endmodule";

static DESIGN: LazyLock<Design> = LazyLock::new(|| {
    Circuit::text("swept.v", CIRCUIT).session().elaborate().unwrap_or_else(|report| panic!("{report}"))
});

fuzz_target!(|bytes: &[u8]| -> Corpus { check(bytes) });

/// What is read is fed as often as it is counted, from anywhere; what is not says why.
fn check(bytes: &[u8]) -> Corpus {
    let mut file = tempfile::NamedTempFile::new_in("/dev/shm").expect("a file");
    file.write_all(bytes).and_then(|()| file.rewind()).expect("it is written");
    let stimuli = match Stimuli::from_csv(file.path(), &DESIGN) {
        Ok(stimuli) => stimuli,
        Err(report) => {
            assert!((1..=101).contains(&report.diagnostics.len()));
            assert!(report.render(false).starts_with("error["));
            return Corpus::Keep;
        }
    };
    let rows = |from: u64| {
        let mut feed = stimuli.feed(from..stimuli.count()).expect("it has been read before");
        let mut words = vec![0; stimuli.inputs()];
        std::iter::from_fn(move || feed(&mut words).then(|| words.clone())).collect::<Vec<_>>()
    };
    let all = rows(0);
    assert_eq!(all.len() as u64, stimuli.count());
    for row in &all {
        assert!(DESIGN.inputs().zip(row).all(|(port, &word)| port.width == 64 || word >> port.width == 0));
    }
    let half = all.len() / 2;
    assert_eq!(rows(half as u64), all[half..]);
    Corpus::Keep
}
