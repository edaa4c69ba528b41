//! Ctrl-C: long work ends soon and in order.

use std::sync::Once;
use std::sync::atomic::{AtomicBool, Ordering};

static INTERRUPTED: AtomicBool = AtomicBool::new(false);
static HANDLER: Once = Once::new();

/// What becomes true at the first Ctrl-C from now on; the second one ends the program at once.
pub(super) fn flag() -> &'static AtomicBool {
    HANDLER.call_once(|| {
        let handler = || {
            if INTERRUPTED.swap(true, Ordering::Relaxed) {
                // 128 and the number of SIGINT, as shells have it.
                std::process::exit(130);
            }
        };
        // Without a handler Ctrl-C just ends the program.
        let _ = ctrlc::set_handler(handler);
    });
    &INTERRUPTED
}
