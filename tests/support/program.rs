//! The program as a user runs it, in a folder of its own.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// A counter of the ticks in which `go` is high.
const COUNTER: &str = "module y (input wire clk, input wire go, output wire [3:0] count, output wire carry);\n\
    binary_counter #(.WIDTH(4)) counter_1 (.clk(clk), .clear(1'b0), .step(go), .count(count), .overflow(carry));\n\
    endmodule\n";

/// A folder with the circuit `y.v`.
pub struct Folder(tempfile::TempDir);

impl Folder {
    /// A new one.
    pub fn new() -> Self {
        let folder = Self(tempfile::tempdir().expect("a folder"));
        folder.write("y.v", COUNTER);
        folder
    }

    /// A path in it.
    pub fn at(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    /// Writes a file.
    pub fn write(&self, name: &str, text: impl AsRef<[u8]>) {
        fs::write(self.at(name), text).expect("a file");
    }

    /// Reads a file.
    pub fn read(&self, name: &str) -> Vec<u8> {
        fs::read(self.at(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    /// The names of all files, in order.
    pub fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(self.0.path()).expect("the folder");
        let mut names: Vec<_> =
            entries.map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned()).collect();
        names.sort();
        names
    }

    /// The program with some arguments, ready to be run in the folder.
    pub fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_stepwright"));
        command.current_dir(self.0.path()).args(arguments).env_remove("CI").env_remove("STEPWRIGHT_BLESS");
        command
    }

    /// Runs the program.
    pub fn run(&self, arguments: &[&str]) -> Output {
        self.command(arguments).output().expect("the program runs")
    }

    /// Runs the program, which does well.
    pub fn done(&self, arguments: &[&str]) -> Output {
        let output = self.run(arguments);
        assert!(output.status.success(), "{arguments:?}: {}", said(&output));
        output
    }

    /// Runs the program, which refuses that with all of `parts`, and leaves every file as it was.
    pub fn refused(&self, arguments: &[&str], parts: &[&str]) {
        let before: Vec<_> = self.names().into_iter().map(|name| (contents(&self.at(&name)), name)).collect();
        let output = self.run(arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {}", said(&output));
        for part in parts {
            assert!(said(&output).contains(part), "{arguments:?}: `{part}` is not in:\n{}", said(&output));
        }
        let after: Vec<_> = self.names().into_iter().map(|name| (contents(&self.at(&name)), name)).collect();
        assert!(before == after, "{arguments:?} changed a file");
    }
}

fn contents(path: &Path) -> Option<Vec<u8>> {
    path.is_file().then(|| fs::read(path).expect("a file"))
}

/// What a program has written to standard error.
pub fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// Standard output and error of a program into pipes.
pub fn piped(command: &mut Command) -> &mut Command {
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped())
}
