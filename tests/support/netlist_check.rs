//! What holds for every text whatsoever; the property tests and the fuzz target share it.

use std::sync::Arc;

use stepwright::base::Report;
use stepwright::base::word::MAX_WIDTH;
use stepwright::compile::{Observe, compile};
use stepwright::netlist::{Drive, Library, Netlist, Part, Source, load};

struct Nothing;

impl Library for Nothing {
    fn find(&self, _: &str) -> Option<Result<(String, Arc<str>), Report>> {
        None
    }
}

/// Loads a text. What loads keeps the invariants of the netlist and compiles; what does not says why.
///
/// # Panics
/// When one of these does not hold.
pub fn check(text: &str) {
    match load("circuit.v", text, None, &Nothing, &[]) {
        Ok(netlist) => {
            keeps_invariants(&netlist);
            let program = compile(&netlist, &Observe::EVERYTHING);
            assert_eq!(program.inputs.len(), netlist.inputs.len());
        }
        Err(report) => {
            assert!(!report.diagnostics.is_empty(), "a text is refused without a reason");
            for diagnostic in &report.diagnostics {
                assert!(diagnostic.code > "N000" && diagnostic.code < "N051", "{diagnostic:?}");
                let places = &diagnostic.labels;
                assert!(places.iter().all(|(span, _)| span.start <= span.end && span.end as usize <= text.len()));
            }
            assert!(report.render(false).starts_with("error[N"));
            assert!(!report.render(true).is_empty());
        }
    }
}

fn keeps_invariants(netlist: &Netlist) {
    for net in &netlist.nets {
        assert!((1..=MAX_WIDTH).contains(&net.width), "{net:?}");
        for drives in [&net.drives, &net.roots] {
            assert!(net.is_clock || covers(drives, net.width), "{net:?}");
        }
        assert!(!net.roots.iter().any(|root| matches!(root.source, Source::Net { .. })), "{net:?}");
    }
    for cell in &netlist.cells {
        assert_eq!(cell.inputs.len(), cell.body.inputs.len());
        for (parts, &width) in cell.inputs.iter().zip(&cell.body.inputs) {
            assert_eq!(parts.iter().map(|part| part_width(*part)).sum::<u32>(), width, "{cell:?}");
        }
    }
    for (place, scope) in netlist.scopes.iter().enumerate() {
        assert_eq!(place == 0, scope.parent.is_none());
        assert!(scope.parent.is_none_or(|parent| parent.index() < place), "{scope:?}");
    }
}

fn covers(drives: &[Drive], width: u32) -> bool {
    let end = drives.iter().try_fold(0, |end, drive| (drive.low == end).then_some(end + drive.width));
    end == Some(width)
}

fn part_width(part: Part) -> u32 {
    match part {
        Part::Net { width, .. } | Part::Const { width, .. } => width,
    }
}
