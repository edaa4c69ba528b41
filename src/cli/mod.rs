//! The command line: the only room that prints.

mod accuracy;
mod args;
mod check;
mod completions;
mod diff;
mod draw;
mod drivers;
mod export;
mod interrupt;
mod list;
mod long_run;
mod observers;
mod result;
mod run;
mod show;
mod stats;
mod sweep;

use std::io::{self, IsTerminal, Write};
use std::path::Path;
use std::process::ExitCode;

use clap::Parser;

use crate::base::Report;
use crate::files;
use args::{Arguments, Command};
pub use sweep::Stimuli;

/// How a command ended; the exit status of DESIGN part 4.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Ending {
    /// Done, and everything equal.
    Done,
    /// A difference, a failed expectation, a limit reached, an interruption.
    Different,
    /// Wrong input, which has been reported already.
    Wrong,
    /// Nothing was selected.
    Nothing,
    /// The reader of the output has gone away, which ends the program quietly.
    Unread,
}

impl From<Ending> for ExitCode {
    fn from(ending: Ending) -> Self {
        ExitCode::from(match ending {
            Ending::Done => 0,
            Ending::Different => 1,
            Ending::Wrong => 2,
            Ending::Nothing => 3,
            // 128 and the number of SIGPIPE, which shells have of programs that it ends.
            Ending::Unread => 141,
        })
    }
}

/// Parses the command line, does what it says, and tells how it ended. Wrong usage or input ends with 2.
#[must_use]
pub fn main() -> ExitCode {
    completions::answer();
    interrupt::listen();
    let ended = match Arguments::try_parse() {
        Ok(arguments) => command(arguments.command),
        Err(wrong) if wrong.use_stderr() => {
            let _ = wrong.print();
            Ok(Ending::Wrong)
        }
        // What was asked for: help, or the version.
        Err(asked) => asked.print().map(|()| Ending::Done).map_err(|error| unprintable(&error)),
    };
    ended
        .unwrap_or_else(|report| {
            if files::is_left_by_reader(&report) {
                return Ending::Unread;
            }
            complain(&report);
            Ending::Wrong
        })
        .into()
}

fn command(command: Command) -> Result<Ending, Report> {
    match command {
        Command::List { what, json } => list::list(&what, json),
        Command::Show { name, source, json } => show::show(&name, source, json),
        Command::Run(arguments) => run::run(&arguments),
        Command::Check(arguments) => check::check(&arguments),
        Command::Diff(arguments) => diff::diff(&arguments),
        Command::Accuracy(arguments) => accuracy::accuracy(&arguments),
        Command::Draw(arguments) => draw::draw_file(&arguments),
        Command::Sweep(arguments) => sweep::sweep(&arguments),
        Command::Merge(arguments) => sweep::merge(&arguments),
        Command::Export { target, verilog } => export::export(&target, &verilog),
        Command::Completions { shell } => {
            print(&completions::script(shell))?;
            Ok(Ending::Done)
        }
    }
}

/// Whether to write colours: to a terminal, unless `NO_COLOR` is set (no-color.org) or the terminal is dumb.
fn colored(stream: &impl IsTerminal) -> bool {
    let set = |name| std::env::var_os(name).is_some_and(|value| !value.is_empty());
    stream.is_terminal() && !set("NO_COLOR") && std::env::var_os("TERM").is_none_or(|term| term != "dumb")
}

/// Checks what a command reads and writes, and tells what a program that was killed has left of its outputs.
///
/// # Errors
/// Those of [`files::check()`].
fn check_files<'p>(
    reads: impl IntoIterator<Item = &'p Path>,
    writes: impl IntoIterator<Item = &'p Path>,
) -> Result<(), Report> {
    for left in files::check(reads, writes)? {
        say(&format!("removed {}, which a program that was killed had left", left.display()));
    }
    Ok(())
}

/// Writes a result to standard output.
fn print(text: &str) -> Result<(), Report> {
    files::print(text).map_err(|error| unprintable(&error))
}

fn unprintable(error: &io::Error) -> Report {
    files::unwritable(Path::new("-"), error).into()
}

/// Writes a line to standard error. When even that cannot be written, nobody can be told.
fn say(line: &str) {
    let _ = writeln!(io::stderr(), "{line}");
}

/// Writes what is wrong to standard error.
fn complain(report: &Report) {
    let text = report.render(colored(&io::stderr()));
    let _ = io::stderr().write_all(text.as_bytes());
}
