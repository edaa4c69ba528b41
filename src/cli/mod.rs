//! The command line: the only room that prints.

mod args;
mod check;
mod completions;
mod diff;
mod drivers;
mod export;
mod interrupt;
mod list;
mod observers;
mod result;
mod run;
mod show;
mod sweep;

use std::io::{self, IsTerminal, Write};
use std::path::Path;
use std::process::ExitCode;

use clap::Parser;

use crate::base::Report;
use crate::files;
use args::{Arguments, Command};

/// How a command ended; the exit status of DESIGN part 4.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Ending {
    /// Done, and everything equal.
    Done,
    /// A difference, a failed expectation, a limit reached.
    Different,
    /// Wrong input, which has been reported already.
    Wrong,
    /// Nothing was selected.
    Nothing,
}

impl From<Ending> for ExitCode {
    fn from(ending: Ending) -> Self {
        ExitCode::from(match ending {
            Ending::Done => 0,
            Ending::Different => 1,
            Ending::Wrong => 2,
            Ending::Nothing => 3,
        })
    }
}

/// Parses the command line, does what it says, and tells how it ended. Wrong usage or input ends with 2.
#[must_use]
pub fn main() -> ExitCode {
    completions::answer();
    let arguments = Arguments::parse();
    match command(arguments.command) {
        Ok(ending) => ending.into(),
        Err(report) => {
            tell(&report);
            ExitCode::from(2)
        }
    }
}

fn command(command: Command) -> Result<Ending, Report> {
    match command {
        Command::List { what, json } => list::list(&what, json),
        Command::Show { name, source, json } => show::show(&name, source, json),
        Command::Run(arguments) => run::run(&arguments),
        Command::Check { scenarios, bless, engine, json } => check::check(&scenarios, bless, engine, json),
        Command::Diff { a, b, json } => diff::diff(&a, &b, json),
        Command::Sweep(arguments) => sweep::sweep(&arguments),
        Command::Export { target, verilog } => export::export(&target, &verilog),
        Command::Completions { shell } => {
            let wrong = |error| files::unwritable(Path::new("standard output"), &error);
            completions::script(shell).map_err(wrong)?;
            Ok(Ending::Done)
        }
    }
}

/// Writes what is wrong to standard error.
fn tell(report: &Report) {
    eprint!("{}", report.render(colored(&io::stderr())));
}

/// Whether to write colours: to a terminal, unless `NO_COLOR` is set (no-color.org) or the terminal is dumb.
fn colored(stream: &impl IsTerminal) -> bool {
    let set = |name| std::env::var_os(name).is_some_and(|value| !value.is_empty());
    stream.is_terminal() && !set("NO_COLOR") && std::env::var_os("TERM").is_none_or(|term| term != "dumb")
}

/// Writes a result to standard output. A reader that has gone away (`| head`) is no error.
fn print(text: &str) -> Result<(), Report> {
    let mut out = io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
            Err(files::unwritable(Path::new("standard output"), &error).into())
        }
        _ => Ok(()),
    }
}
