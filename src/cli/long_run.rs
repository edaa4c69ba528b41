//! What commands that run long share: a bar, and how to go on when they were interrupted.

use std::io::{self, IsTerminal, Write};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// A bar on standard error when that is a terminal.
pub(super) fn progress(count: u64, done: u64, what: &str) -> ProgressBar {
    let target =
        if std::io::stderr().is_terminal() { ProgressDrawTarget::stderr() } else { ProgressDrawTarget::hidden() };
    let bar = ProgressBar::with_draw_target(Some(count), target).with_position(done);
    let style = format!("{{wide_bar}} {{human_pos}} of {{human_len}} {what}, {{per_sec}}, {{eta}} left");
    let style = ProgressStyle::with_template(&style);
    bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
    bar.reset_eta();
    bar
}

/// Tells how to go on, as it can be typed, behind where the work is that has been done.
pub(super) fn hint(done: &str) {
    let mut typed: Vec<_> = std::env::args_os().filter(|word| word != "--resume").collect();
    // After the name of the command: what follows may be cut by a `--`.
    typed.insert(2.min(typed.len()), "--resume".into());
    let words = typed.iter().map(|word| word.as_encoded_bytes());
    let mut line = format!("{done}; to go on:\n  ").into_bytes();
    // An argument has no NUL, which is all that cannot be quoted.
    line.extend(shlex::bytes::try_join(words).unwrap_or_default());
    line.push(b'\n');
    let _ = io::stderr().write_all(&line);
}
