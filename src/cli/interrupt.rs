//! Signals: what is asked to end does so soon and in order, and leaves nothing unfinished behind.
//!
//! At the first Ctrl-C (or TERM, or HUP) a long work ends in order, if the command has one; everything else ends at
//! once, as it does at the second. A work that still waits for a reader of its output after that has nothing left to
//! put in order. What is ignored when the program starts, as HUP is under `nohup`, stays so.

use std::sync::atomic::{AtomicBool, Ordering};

static INTERRUPTED: AtomicBool = AtomicBool::new(false);
/// Whether somebody looks at [`INTERRUPTED`].
static IS_HEEDED: AtomicBool = AtomicBool::new(false);

/// What becomes true at the first signal from now on. Whoever asks looks at it at least a few times a second.
pub(super) fn flag() -> &'static AtomicBool {
    IS_HEEDED.store(true, Ordering::Relaxed);
    &INTERRUPTED
}

/// Begins to listen; once. Elsewhere than on Unix Ctrl-C just ends the program.
pub(super) fn listen() {
    #[cfg(unix)]
    unix::listen();
}

#[cfg(unix)]
mod unix {
    use std::sync::atomic::Ordering;
    use std::thread;
    use std::time::Duration;

    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
    use signal_hook::iterator::Signals;
    use signal_hook::low_level::emulate_default_handler;

    use super::{INTERRUPTED, IS_HEEDED};
    use crate::files;

    /// How often to look for a second signal.
    const BEAT: Duration = Duration::from_millis(50);
    /// How many beats a reader may keep us waiting.
    const PATIENCE: u32 = 8;

    pub(super) fn listen() {
        let ignored = ignored();
        let heard = [SIGINT, SIGTERM, SIGHUP].into_iter().filter(|signal| ignored >> (signal - 1) & 1 == 0);
        // Without it signals end the program as they do by default.
        if let Ok(signals) = Signals::new(heard) {
            thread::spawn(move || watch(signals));
        }
    }

    /// The signals that are ignored, one bit each; where the system does not tell, none.
    fn ignored() -> u64 {
        let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
        let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
        mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok()).unwrap_or(0)
    }

    fn watch(mut signals: Signals) {
        let Some(first) = signals.forever().next() else { return };
        if !IS_HEEDED.load(Ordering::Relaxed) {
            end(first);
        }
        INTERRUPTED.store(true, Ordering::Relaxed);
        let mut waited = 0;
        while waited < PATIENCE {
            thread::sleep(BEAT);
            if let Some(second) = signals.pending().next() {
                end(second);
            }
            waited = if files::is_waiting() { waited + 1 } else { 0 };
        }
        end(first);
    }

    /// Ends the program by a signal, so that whoever started it sees which.
    fn end(signal: i32) -> ! {
        files::abandon();
        let _ = emulate_default_handler(signal);
        std::process::exit(128 + signal)
    }
}
