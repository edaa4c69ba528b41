//! Drivers: every bit of every net has just one.

use super::template::{LocalDrive, LocalNet};
use crate::base::Diagnostic;

/// Sorts a net's drivers by bits and says what is wrong with them.
pub(super) fn check(net: &mut LocalNet) -> Vec<Diagnostic> {
    net.drives.sort_by_key(|drive| drive.low);
    if net.is_clock { Vec::new() } else { twice(net).into_iter().chain(undriven(net)).collect() }
}

/// The first bits with two drivers.
fn twice(net: &LocalNet) -> Option<Diagnostic> {
    let mut furthest: Option<&LocalDrive> = None;
    for drive in &net.drives {
        if let Some(other) = furthest.filter(|other| other.low + other.width > drive.low) {
            let end = (other.low + other.width).min(drive.low + drive.width);
            let (first, second) = if other.span <= drive.span { (other, drive) } else { (drive, other) };
            let bits = net.bits(drive.low, end - drive.low);
            let diagnostic = Diagnostic::new("N007", format!("`{bits}` has two drivers"));
            return Some(
                diagnostic
                    .at(second.span, "driven again here")
                    .at(first.span, "first driven here")
                    .help("a net has one driver: join the two with a gate or a block, or give each a net of its own"),
            );
        }
        furthest = Some(drive);
    }
    None
}

/// The bits without a driver.
fn undriven(net: &LocalNet) -> Option<Diagnostic> {
    let mut gaps = Vec::new();
    let mut next = 0;
    for drive in &net.drives {
        if drive.low > next {
            gaps.push(net.bits(next, drive.low - next));
        }
        next = next.max(drive.low + drive.width);
    }
    if next < net.width {
        let whole = next == 0;
        gaps.push(if whole { net.name.clone() } else { net.bits(next, net.width - next) });
    }
    if gaps.is_empty() {
        return None;
    }
    let list: Vec<_> = gaps.iter().map(|bits| format!("`{bits}`")).collect();
    let diagnostic = Diagnostic::new("N008", format!("nothing drives {}", list.join(", ")));
    let help = "drive it with an `assign`, a gate or an instance's output, or leave it out";
    Some(diagnostic.at(net.span, "declared here").help(help))
}
