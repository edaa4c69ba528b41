//! The tools that judge from outside: whether they are here, and how they are run.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// Whether `tools` are installed. When one is missing the check is skipped loudly, or fails if
/// `STEPWRIGHT_REQUIRE_TOOLS` is set, as continuous integration does.
pub fn present(tools: &[&str]) -> bool {
    let path = std::env::var_os("PATH").unwrap_or_default();
    let has = |tool: &&&str| std::env::split_paths(&path).any(|folder| folder.join(tool).is_file());
    let missing: Vec<_> = tools.iter().filter(|tool| !has(tool)).collect();
    if missing.is_empty() {
        return true;
    }
    let required = std::env::var_os("STEPWRIGHT_REQUIRE_TOOLS").is_some();
    assert!(
        !required,
        "missing: {missing:?}. Install them: apt-get install iverilog verilator yosys gtkwave xvfb xauth"
    );
    // Straight to the standard error: the test harness hides what is printed by a test that passes.
    use std::io::Write;
    let message = format!(
        "\n*** SKIPPED, NOT CHECKED: {missing:?} not installed (apt-get install iverilog verilator yosys gtkwave xvfb xauth) ***\n"
    );
    std::io::stderr().write_all(message.as_bytes()).expect("standard error takes text");
    false
}

/// Runs a command in a folder and demands success.
pub fn run(folder: &Path, program: &str, arguments: &[&str]) -> Output {
    let output = Command::new(program).args(arguments).current_dir(folder).output();
    let output = output.unwrap_or_else(|error| panic!("{program}: {error}"));
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).chars().take(4000).collect::<String>();
    assert!(
        output.status.success(),
        "{program} {arguments:?} in {}: {}\n{}{}",
        folder.display(),
        output.status,
        text(&output.stderr),
        text(&output.stdout)
    );
    output
}

/// Compiles all Verilog files of a folder with Icarus, without a warning, and runs the bench.
pub fn icarus(folder: &Path, bench: &str) {
    let entries = std::fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").file_name());
    let mut files: Vec<_> = entries.map(|name| name.into_string().expect("a plain name")).collect();
    files.retain(|name| name.ends_with(".v"));
    files.sort();
    // The circuit files name no time unit, as they hold no delay; that one warning is of no use.
    let mut arguments = vec!["-g2005", "-Wall", "-Wno-timescale", "-s", bench, "-o", "bench.vvp"];
    arguments.extend(files.iter().map(String::as_str));
    let compiled = run(folder, "iverilog", &arguments);
    let warnings = String::from_utf8_lossy(&compiled.stderr);
    assert!(warnings.is_empty(), "{}: {warnings}", folder.display());
    run(folder, "vvp", &["-n", "bench.vvp"]);
}

/// All files with an ending below a folder of the repository.
pub fn files_below(folder: &str, ending: &str) -> Vec<PathBuf> {
    let (mut found, mut open) = (Vec::new(), vec![Path::new(env!("CARGO_MANIFEST_DIR")).join(folder)]);
    while let Some(folder) = open.pop() {
        for path in std::fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path()) {
            if path.is_dir() {
                open.push(path);
            } else if path.extension().is_some_and(|own| own == ending) {
                found.push(path);
            }
        }
    }
    found
}
