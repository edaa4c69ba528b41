//! Nothing of the user's is lost by an output: what may be written, and how.

use std::fs::{self, File};
use std::io::{Read, Write};
use std::os::unix::fs::{MetadataExt, PermissionsExt, chown, symlink};
use std::process::{Command, Stdio};

use crate::support::program::{Folder, piped, said};

#[test]
fn an_output_that_is_an_input_by_whatever_name_is_refused() {
    let folder = Folder::new();
    folder.write("y.toml", "circuit = \"./y.v\"\n[stop]\nticks = 5\n");
    folder.write("io.csv", "go\n1\n0\n");
    folder.write(
        "top.v",
        "module top (input wire clk, input wire go, output wire carry);\n    \
        y y_1 (.clk(clk), .go(go), .carry(carry));\nendmodule\n",
    );
    symlink("y.v", folder.at("link.v")).expect("a link");
    fs::hard_link(folder.at("y.v"), folder.at("hard.v")).expect("a hard link");
    for output in ["y.v", "./y.v", "link.v", "hard.v", "y.toml"] {
        folder.refused(&["run", "./y.v", "--ticks", "5", "--vcd", output], &["C030", output]);
    }
    folder.refused(&["run", "./top.v", "--ticks", "5", "--csv", "y.v"], &["C030", "y.v"]);
    folder.refused(&["sweep", "./y.v", "--from", "io.csv", "--out", "io.csv"], &["C030", "io.csv"]);
    symlink("y.v", folder.at("y.csv")).expect("a link");
    folder.refused(&["sweep", "./y.v", "--from", "io.csv", "--out", "y.csv"], &["C030"]);
    let command = &mut folder.command(&["sweep", "./y.v", "--from", "io.csv"]);
    let appending = fs::OpenOptions::new().append(true).open(folder.at("io.csv")).expect("a file");
    let output = command.stdout(appending).stderr(Stdio::piped()).output().expect("runs");
    assert!(said(&output).contains("standard output is the same file as io.csv"), "{}", said(&output));
    assert_eq!(folder.read("io.csv"), b"go\n1\n0\n");
}

#[test]
fn two_outputs_that_are_one_file_are_refused() {
    let folder = Folder::new();
    symlink("new.vcd", folder.at("to_new.vcd")).expect("a link that leads nowhere yet");
    for [one, other] in [
        ["--vcd=a", "--gtkw=a"],
        ["--vcd=b", "--fst=./b"],
        ["--vcd=to_new.vcd", "--csv=new.vcd"],
        ["--vcd=-", "--csv=-"],
    ] {
        folder.refused(&["run", "./y.v", "--ticks", "5", one, other], &["C030", "two outputs"]);
    }
    folder.done(&["run", "./y.v", "--ticks", "5", "--vcd", "/dev/null", "--csv", "/dev/null"]);
}

#[test]
fn export_overwrites_only_what_it_has_written() {
    let folder = Folder::new();
    folder.refused(&["export", "./y.v", "--ticks", "5", "--verilog", "."], &["C030", "y.v"]);
    fs::create_dir(folder.at("out")).expect("a folder");
    folder.write("out/bench.v", "// mine\n");
    folder.refused(&["export", "./y.v", "--ticks", "5", "--verilog", "out"], &["C032", "bench.v"]);
    assert_eq!(folder.read("out/bench.v"), b"// mine\n");
    assert!(!folder.at("out/blocks.v").exists(), "nothing is written");
    fs::remove_file(folder.at("out/bench.v")).expect("a file");
    folder.done(&["export", "./y.v", "--ticks", "5", "--verilog", "out"]);
    let bench = folder.read("out/bench.v");
    folder.done(&["export", "./y.v", "--ticks", "6", "--verilog", "out"]);
    assert_ne!(folder.read("out/bench.v"), bench, "its own files it writes again");
}

#[test]
fn a_golden_that_is_the_scenario_itself_is_not_blessed() {
    let folder = Folder::new();
    for name in ["circuits", "traces"] {
        fs::create_dir(folder.at(name)).expect("a folder");
    }
    folder.write("circuits/a.toml", "circuit = \"../y.v\"\n[stop]\nticks = 5\n");
    fs::hard_link(folder.at("circuits/a.toml"), folder.at("traces/a.vcd")).expect("a hard link");
    let before = folder.read("circuits/a.toml");
    folder.refused(&["check", "--bless"], &["C030", "circuits/a.toml"]);
    assert_eq!(folder.read("circuits/a.toml"), before);
}

#[test]
fn paths_need_not_be_text() {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;
    let folder = Folder::new();
    let name = |bytes| folder.at("").join(OsStr::from_bytes(bytes));
    let (circuit, waves, rows) = (name(b"y\xff.v"), name(b"\xff.vcd"), name(b"\xff.csv"));
    fs::copy(folder.at("y.v"), &circuit).expect("a file");
    let run = |command: &str, more: &[&str], output: &std::path::Path| {
        folder.command(&[command]).arg(&circuit).args(["--ticks", "5"]).args(more).arg(output).output().expect("runs")
    };
    for output in [run("run", &["--vcd"], &waves), run("sweep", &["--over", "go=0,1", "--out"], &rows)] {
        assert!(output.status.success(), "{}", said(&output));
    }
    assert!(waves.is_file() && fs::read_to_string(rows).expect("a file").lines().count() == 3);
    assert!(said(&run("run", &["--vcd"], &circuit)).contains("C030"), "an input is known by any name");
}

#[test]
fn links_are_followed_and_devices_are_written_through() {
    let folder = Folder::new();
    let whole = ["run", "./y.v", "--ticks", "5", "--vcd", "plain.vcd"];
    folder.done(&whole);
    let vcd = folder.read("plain.vcd");
    folder.write("old.vcd", "old");
    for (link, to) in [("to_old", "old.vcd"), ("to_new", "new.vcd"), ("to_link", "to_old")] {
        symlink(to, folder.at(link)).expect("a link");
        folder.write("old.vcd", "old");
        folder.done(&["run", "./y.v", "--ticks", "5", "--vcd", link]);
        assert!(folder.at(link).is_symlink(), "{link}");
        assert_eq!(folder.read(link), vcd, "{link}");
        assert!(!folder.at(to).is_symlink() || to == "to_old", "{to}");
    }
    // As /dev/stdout is, which a test had better not put at risk.
    symlink("/proc/self/fd/1", folder.at("stdout")).expect("a link");
    let out = File::create(folder.at("out.vcd")).expect("a file");
    let mut command = folder.command(&["run", "./y.v", "--ticks", "5", "--vcd", "stdout"]);
    let output = command.stdout(out).stderr(Stdio::piped()).output().expect("runs");
    assert!(output.status.success() && folder.at("stdout").is_symlink(), "{}", said(&output));
    assert_eq!(folder.read("out.vcd"), vcd);
    assert!(said(&output).contains("5 ticks"), "the result goes where it does not mix with the waveform");
}

#[test]
fn a_pipe_is_written_through() {
    let folder = Folder::new();
    folder.done(&["run", "./y.v", "--ticks", "5", "--vcd", "plain.vcd"]);
    let pipe = folder.at("pipe");
    assert!(Command::new("mkfifo").arg(&pipe).status().expect("mkfifo").success());
    let reader = std::thread::spawn(move || {
        let mut bytes = Vec::new();
        File::open(pipe).and_then(|mut pipe| pipe.read_to_end(&mut bytes)).expect("a pipe");
        bytes
    });
    folder.done(&["run", "./y.v", "--ticks", "5", "--vcd", "pipe"]);
    assert_eq!(reader.join().expect("a reader"), folder.read("plain.vcd"));
    assert!(!folder.at("pipe").is_file());
}

#[test]
fn a_read_only_file_is_refused_and_another_keeps_owner_mode_and_names() {
    let folder = Folder::new();
    let run = ["run", "./y.v", "--ticks", "5", "--vcd", "a.vcd"];
    folder.write("a.vcd", "old");
    let mode = |mode| fs::set_permissions(folder.at("a.vcd"), fs::Permissions::from_mode(mode)).expect("a mode");
    mode(0o444);
    folder.refused(&run, &["C003", "a.vcd", "read-only"]);
    mode(0o640);
    let is_root = chown(folder.at("a.vcd"), Some(12345), Some(54321)).is_ok();
    folder.done(&run);
    let about = fs::metadata(folder.at("a.vcd")).expect("a file");
    assert_eq!(about.mode() & 0o7777, 0o640);
    assert!(!is_root || (about.uid(), about.gid()) == (12345, 54321));
    assert!(folder.read("a.vcd").starts_with(b"$version"));
    folder.write("a.vcd", "old and longer than what comes, so that a rest would be seen".repeat(100));
    fs::hard_link(folder.at("a.vcd"), folder.at("b.vcd")).expect("a hard link");
    folder.done(&run);
    assert_eq!(folder.read("a.vcd"), folder.read("b.vcd"));
    assert!(folder.read("b.vcd").ends_with(b"#5\n"));
}

#[test]
fn a_minus_is_standard_output_for_every_output() {
    let folder = Folder::new();
    let of = |arguments: &[&str]| folder.done(arguments).stdout;
    folder.done(&["run", "./y.v", "--ticks", "5", "--csv", "rows.csv", "--vcd", "a.vcd"]);
    assert_eq!(of(&["run", "./y.v", "--ticks", "5", "--csv", "-"]), folder.read("rows.csv"));
    assert_eq!(of(&["run", "./y.v", "--ticks", "5", "--wave", "-"]), folder.read("a.vcd"));
    folder.done(&["run", "./y.v", "--ticks", "5", "--fst", "a.fst"]);
    assert_eq!(of(&["run", "./y.v", "--ticks", "5", "--fst", "-"]), folder.read("a.fst"));
    let sweep = ["sweep", "./y.v", "--ticks", "5", "--over", "go=0,1"];
    assert_eq!(of(&[&sweep[..], &["--out", "-"]].concat()), of(&sweep));
    assert!(!folder.at("-").exists() && !folder.at("-.sweep").exists());
}

#[test]
fn what_a_killed_program_left_is_told_and_removed_but_not_what_another_one_writes() {
    let folder = Folder::new();
    folder.write(".a.vcd.unfinished", "half");
    let output = folder.done(&["run", "./y.v", "--ticks", "5", "--vcd", "a.vcd"]);
    assert!(said(&output).contains(".a.vcd.unfinished"), "{}", said(&output));
    assert_eq!(folder.names(), ["a.vcd", "y.v"]);
    folder.write(".a.vcd.unfinished", "half");
    let lock = File::open(folder.at(".a.vcd.unfinished")).expect("a file");
    lock.lock().expect("a lock");
    folder.refused(&["run", "./y.v", "--ticks", "5", "--vcd", "a.vcd"], &["C031", "a.vcd"]);
}

#[test]
fn the_folder_is_blamed_only_for_what_lies_with_it() {
    let folder = Folder::new();
    let run = |path: &str| said(&folder.run(&["run", "./y.v", "--ticks", "5", "--vcd", path]));
    assert!(run("nowhere/a.vcd").contains("there is no folder nowhere"), "{}", run("nowhere/a.vcd"));
    for path in [".", "/dev/full"] {
        assert!(run(path).contains("C003") && !run(path).contains("folder"), "{}", run(path));
    }
}

/// Everything that prints a result.
const PRINTING: [&[&str]; 9] = [
    &["list"],
    &["show", "summer"],
    &["run", "./y.v", "--ticks", "5"],
    &["run", "./y.v", "--ticks", "5", "--json"],
    &["run", "./y.v", "--ticks", "5", "--vcd", "-"],
    &["sweep", "./y.v", "--ticks", "5", "--over", "go=0,1"],
    &["check", "y.toml"],
    &["completions", "bash"],
    &["--help"],
];

#[test]
fn a_full_standard_output_is_an_error_that_is_told() {
    let folder = Folder::new();
    folder.write("y.toml", "circuit = \"y.v\"\n[stop]\nticks = 5\n");
    for arguments in PRINTING {
        let full = File::options().write(true).open("/dev/full").expect("a device");
        let output = folder.command(arguments).stdout(full).stderr(Stdio::piped()).output().expect("runs");
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {}", said(&output));
        assert!(said(&output).contains("standard output") && said(&output).contains("full"), "{}", said(&output));
    }
}

#[test]
fn a_reader_that_has_gone_ends_the_program_quietly_with_the_status_of_sigpipe() {
    let folder = Folder::new();
    // C033 is what it would be called, were there anybody to be told. A `check` that finds nothing prints nothing.
    for arguments in PRINTING.iter().filter(|arguments| arguments[0] != "check") {
        let (reader, writer) = std::io::pipe().expect("a pipe");
        drop(reader);
        let output = folder.command(arguments).stdout(writer).stderr(Stdio::piped()).output().expect("runs");
        assert_eq!((output.status.code(), said(&output).as_str()), (Some(141), ""), "{arguments:?}");
    }
}

#[test]
fn what_cannot_even_be_complained_about_does_not_panic() {
    let folder = Folder::new();
    folder.write("y.toml", "circuit = \"./y.v\"\n[stop]\nticks = 5\n[expect]\nticks = 6\n");
    let limit = ["run", "./y.v", "--until", "carry", "--limit", "5"];
    for (arguments, status) in [(&["run", "nothing"][..], 2), (&["check"], 3), (&["run", "y.toml"], 1), (&limit, 1)] {
        let full = File::options().write(true).open("/dev/full").expect("a device");
        let ended = folder.command(arguments).stdout(Stdio::null()).stderr(full).status().expect("runs");
        assert_eq!(ended.code(), Some(status), "{arguments:?}");
    }
}

#[test]
fn folders_that_links_lead_to_again_are_visited_once() {
    let folder = Folder::new();
    fs::create_dir_all(folder.at("circuits/real")).expect("a folder");
    folder.write("circuits/real/a.toml", "circuit = \"su1522157/interpolator\"\n[stop]\nticks = 1\n");
    for link in ["circuits/one", "circuits/two"] {
        symlink(".", folder.at(link)).expect("a link");
    }
    symlink("real", folder.at("circuits/alias")).expect("a link");
    let output = folder.run(&["check"]);
    assert_eq!(String::from_utf8_lossy(&output.stdout).matches(".toml").count(), 2, "its line, and how to bless it");
    assert!(String::from_utf8_lossy(&output.stdout).contains("circuits/real/a.toml"));
}

#[test]
fn a_scenario_beside_a_circuit_that_names_another_one_is_not_applied() {
    let folder = Folder::new();
    folder.write("other.v", String::from_utf8_lossy(&folder.read("y.v")).replace("module y", "module other"));
    for (named, is_applied) in [("y.v", true), ("./y.v", true), ("other.v", false), ("su1522157/interpolator", false)] {
        folder.write("y.toml", format!("circuit = \"{named}\"\n[stop]\nticks = 3\n"));
        let result = String::from_utf8_lossy(&folder.done(&["run", "./y.v"]).stdout).into_owned();
        assert_eq!(result.contains("\n3 ticks"), is_applied, "{named}: {result}");
    }
}

#[test]
fn no_two_columns_share_a_name() {
    let folder = Folder::new();
    folder.write(
        "t.v",
        "module t (input wire stopped_by, input wire tick, output wire ticks);\n    \
        and gate_1 (ticks, stopped_by, tick);\nendmodule\n",
    );
    let sweep = folder.done(&["sweep", "./t.v", "--ticks", "2", "--over", "stopped_by=0,1"]);
    let table = folder.done(&["run", "./t.v", "--ticks", "2", "--csv", "-"]);
    for text in [sweep.stdout, table.stdout] {
        let header = String::from_utf8_lossy(&text).lines().next().expect("a header").to_owned();
        let mut names: Vec<_> = header.split(',').collect();
        names.sort_unstable();
        assert!(names.windows(2).all(|pair| pair[0] != pair[1]), "{header}");
    }
    folder.refused(&["run", "./y.v", "--ticks", "2", "--csv", "-", "--columns", "go,count,go"], &["W007", "`go`"]);
}

#[test]
fn stimuli_may_come_from_a_pipe_and_all_that_is_wrong_with_them_is_told() {
    let folder = Folder::new();
    let sweep = |text: &str| {
        let mut command = folder.command(&["sweep", "./y.v", "--ticks", "5", "--from", "/dev/stdin"]);
        let mut child = piped(&mut command).stdin(Stdio::piped()).spawn().expect("starts");
        child.stdin.take().expect("a pipe").write_all(text.as_bytes()).expect("written");
        child.wait_with_output().expect("runs")
    };
    let over = folder.done(&["sweep", "./y.v", "--ticks", "5", "--over", "go=0,1"]);
    assert_eq!(sweep("go\n0\n1\n").stdout, over.stdout);
    let wrong = sweep("go\n2\n1,1\nx\n0\n-1\n");
    let places: Vec<_> = (1..=6).filter(|line| said(&wrong).contains(&format!("stdin:{line}:"))).collect();
    assert_eq!((wrong.status.code(), places), (Some(2), vec![2, 3, 4, 6]), "{}", said(&wrong));
}

#[test]
fn absurd_numbers_of_threads_are_refused() {
    Folder::new().refused(&["sweep", "./y.v", "--over", "go=0,1", "--threads", "65535"], &["65535", "1024"]);
}

/// A trace of 16 MB, which took 85 MB of memory when it was kept whole, and takes 14 MB as one of 16 KB does.
#[cfg(target_os = "linux")]
#[test]
fn a_long_run_is_checked_and_blessed_in_memory_that_does_not_grow_with_it() {
    let folder = Folder::new();
    let scenario = |ticks: u64| format!("circuit = \"y\"\n[inputs]\ngo = 1\n[stop]\nticks = {ticks}\n");
    for ticks in [1_000, 1_000_000] {
        folder.write("y.toml", scenario(ticks));
        for (more, said) in [("--bless", "1 blessed"), ("", "1 equal")] {
            let program = env!("CARGO_BIN_EXE_stepwright");
            // Address space, in KiB: the program itself and its threads take most of it.
            let line = format!("ulimit -v 150000; exec {program} check {more} --engine interpreter y.toml");
            let mut command = Command::new("sh");
            command.current_dir(folder.at("")).args(["-c", &line]).env_remove("CI").env("RAYON_NUM_THREADS", "1");
            let output = command.output().expect("a shell");
            let text = String::from_utf8_lossy(&output.stdout);
            assert!(text.contains(said), "{ticks} ticks {more}: {text}{}", crate::support::program::said(&output));
        }
    }
}
