//! What is interrupted ends soon, leaves whole files, and can be gone on with.

use std::fs;
use std::os::unix::process::ExitStatusExt;
use std::process::{Child, Command, ExitStatus, Output};
use std::thread::sleep;
use std::time::{Duration, Instant};

use crate::support::program::{Folder, piped, said};

/// More ticks than any engine runs in a day.
const ENDLESS: &str = "100000000000000";

/// A program that runs; it is killed when a test fails.
struct Running(Option<Child>);

impl Running {
    /// Starts a program and waits until `is_under_way`.
    fn begun(command: &mut Command, is_under_way: impl Fn() -> bool) -> Self {
        let mut running = Self(Some(piped(command).spawn().expect("starts")));
        for _ in 0..6000 {
            if is_under_way() {
                return running;
            }
            assert_eq!(running.status(), None, "{command:?} has ended too soon");
            sleep(Duration::from_millis(5));
        }
        panic!("{command:?} does not begin");
    }

    fn child(&mut self) -> &mut Child {
        self.0.as_mut().expect("a child")
    }

    fn status(&mut self) -> Option<ExitStatus> {
        self.child().try_wait().expect("a child")
    }

    fn send(&mut self, signal: &str) {
        let sent = Command::new("sh").args(["-c", &format!("kill -{signal} {}", self.child().id())]).status();
        assert!(sent.expect("a shell").success(), "{signal} is sent");
    }

    /// What it ends with after a signal, and how long that takes.
    fn ended(mut self, signal: &str) -> (Output, Duration) {
        self.send(signal);
        let since = Instant::now();
        let child = self.0.take().expect("a child");
        (child.wait_with_output().expect("ends"), since.elapsed())
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        let _ = self.0.as_mut().map(Child::kill);
    }
}

fn begun(folder: &Folder, arguments: &[&str], is_under_way: impl Fn() -> bool) -> Running {
    Running::begun(&mut folder.command(arguments), is_under_way)
}

fn length(folder: &Folder, name: &str) -> u64 {
    fs::metadata(folder.at(name)).map_or(0, |about| about.len())
}

#[test]
fn a_run_that_is_interrupted_closes_its_trace_at_the_last_tick_and_leaves_nothing_else() {
    for signal in ["INT", "TERM", "HUP"] {
        let folder = Folder::new();
        let run = ["run", "./y.v", "-s", "go=1", "--ticks", ENDLESS, "--vcd", "a.vcd"];
        let child = begun(&folder, &run, || length(&folder, ".a.vcd.unfinished") > 100_000);
        assert_eq!(folder.names(), [".a.vcd.unfinished", "y.v"], "not under its name before it is whole");
        let (output, _) = child.ended(signal);
        assert_eq!(output.status.code(), Some(1), "{signal}: {}", said(&output));
        let said = said(&output);
        let tick = said.strip_prefix("interrupted at tick ").and_then(|rest| rest.split(';').next());
        let last: u64 = tick.and_then(|tick| tick.parse().ok()).unwrap_or_else(|| panic!("{said}"));
        let vcd = String::from_utf8(folder.read("a.vcd")).expect("text");
        assert!(vcd.ends_with(&format!("\n#{}\n", last + 1)), "the closing time is one past tick {last}");
        // A count of one a tick: no change is missing.
        assert!(vcd.contains(&format!("#{last}\nb{:04b} ", last % 16)), "the last tick is there");
        assert_eq!(folder.names(), ["a.vcd", "y.v"]);
    }
}

#[test]
fn after_a_kill_only_the_file_aside_stays_and_the_next_run_removes_it() {
    let folder = Folder::new();
    folder.write("a.vcd", "what was there before");
    let run = ["run", "./y.v", "-s", "go=1", "--ticks", ENDLESS, "--vcd", "a.vcd"];
    let (output, _) = begun(&folder, &run, || length(&folder, ".a.vcd.unfinished") > 100_000).ended("KILL");
    assert_eq!(output.status.signal(), Some(9));
    assert_eq!(folder.names(), [".a.vcd.unfinished", "a.vcd", "y.v"]);
    assert_eq!(folder.read("a.vcd"), b"what was there before");
    let output = folder.done(&["run", "./y.v", "--ticks", "5", "--vcd", "a.vcd"]);
    assert!(said(&output).contains(".a.vcd.unfinished"), "{}", said(&output));
    assert_eq!(folder.names(), ["a.vcd", "y.v"]);
}

/// Some seconds of work.
const SWEEP: [&str; 6] = ["sweep", "frames.toml", "--over", "major_32=1500..=1755", "--over", "minor_34=3,900..=1027"];

fn frames() -> Folder {
    let folder = Folder::new();
    folder.write(
        "frames.toml",
        "circuit = \"su1522157/interpolator\"\n[[at]]\ntick = 0\nset = { start_33 = 1 }\n\
         [[at]]\ntick = 1\nset = { start_33 = 0 }\n[stop]\nuntil = \"!busy\"\nlimit = 6500\n",
    );
    folder
}

#[test]
fn a_sweep_that_is_interrupted_anyhow_is_resumed_to_the_same_bytes_and_status() {
    let folder = frames();
    let whole = folder.run(&[&SWEEP[..], &["--out", "whole.csv"]].concat());
    // Frames of more than 1625 steps do not end within the limit.
    assert_eq!(whole.status.code(), Some(1), "{}", said(&whole));
    for (signal, threads) in [("INT", "1"), ("TERM", "1"), ("KILL", "1"), ("INT", "3"), ("TERM", "3"), ("KILL", "3")] {
        let name = format!("{signal}{threads}.csv");
        let sweep = [&SWEEP[..], &["--out", &name, "--threads", threads]].concat();
        let (output, _) = begun(&folder, &sweep, || length(&folder, &name) > 100_000).ended(signal);
        let rows = String::from_utf8_lossy(&folder.read(&name)).lines().count();
        let all = String::from_utf8_lossy(&folder.read("whole.csv")).lines().count();
        assert!((2..all).contains(&rows), "{name}: {rows} of {all} lines");
        let is_killed = signal == "KILL";
        assert!(is_killed || said(&output).contains("--resume"), "{}", said(&output));
        assert_eq!(output.status.code(), if is_killed { None } else { Some(1) });
        let output = folder.run(&[&sweep[..], &["--resume"]].concat());
        assert_eq!(output.status.code(), Some(1), "{name}: {}", said(&output));
        assert_eq!(said(&output), said(&whole), "{name}");
        assert!(folder.read(&name) == folder.read("whole.csv"), "{name}");
    }
}

#[test]
fn two_sweeps_do_not_go_into_one_file() {
    let folder = frames();
    let sweep = [&SWEEP[..], &["--out", "out.csv"]].concat();
    let child = begun(&folder, &sweep, || length(&folder, "out.csv") > 0);
    for more in [&[][..], &["--resume"]] {
        let second = folder.run(&[&sweep[..], more].concat());
        assert_eq!(second.status.code(), Some(2), "{more:?}");
        assert!(said(&second).contains("C031"), "{}", said(&second));
    }
    let (first, _) = child.ended("INT");
    assert!(said(&first).contains("interrupted after"), "the first one goes on meanwhile: {}", said(&first));
}

#[test]
fn nothing_else_goes_into_a_file_that_a_sweep_is_writing() {
    let folder = frames();
    let sweep = [&SWEEP[..], &["--out", "out.csv"]].concat();
    let few = [&SWEEP[..2], &["--over", "major_32=1..=3", "--shard", "0/1", "--out", "part.csv"]].concat();
    assert_eq!(folder.run(&few).status.code(), Some(0));
    let child = begun(&folder, &sweep, || length(&folder, "out.csv") > 0);
    for other in
        [&["merge", "part.csv", "--out", "out.csv"][..], &["run", "frames.toml", "--ticks", "9", "--csv", "out.csv"]]
    {
        let other = folder.run(other);
        assert_eq!(other.status.code(), Some(2));
        assert!(said(&other).contains("C031"), "{}", said(&other));
    }
    let before = length(&folder, "out.csv");
    let (first, _) = child.ended("INT");
    assert!(said(&first).contains("interrupted after"), "the sweep goes on meanwhile: {}", said(&first));
    assert!(length(&folder, "out.csv") >= before);
}

#[test]
fn a_sweep_ends_within_a_second_on_every_engine_however_long_a_run_is() {
    for engine in ["interpreter", "native", "lanes", "auto"] {
        let folder = Folder::new();
        let sweep = ["sweep", "./y.v", "--over", "go=0,1", "--ticks", ENDLESS, "--out", "o.csv", "--engine", engine];
        let child = begun(&folder, &sweep, || folder.at("o.csv.sweep").exists());
        sleep(Duration::from_millis(500));
        let (output, time) = child.ended("INT");
        assert_eq!(output.status.code(), Some(1), "{engine}: {}", said(&output));
        assert!(time < Duration::from_secs(1), "{engine} takes {time:?}");
    }
}

#[test]
fn a_sweep_ends_within_a_second_when_nobody_reads_its_rows() {
    for threads in ["1", "3"] {
        let folder = frames();
        let mut child = begun(&folder, &[&SWEEP[..], &["--threads", threads]].concat(), || true);
        sleep(Duration::from_millis(1500));
        child.send("INT");
        // The pipe is read only when the program has ended, or should have.
        sleep(Duration::from_millis(900));
        assert_eq!(child.status().and_then(|status| status.signal()), Some(2), "{threads} threads");
    }
}

#[test]
fn a_second_signal_ends_at_once_and_leaves_nothing() {
    let folder = Folder::new();
    let run = ["run", "./y.v", "-s", "go=1", "--ticks", ENDLESS, "--vcd", "a.vcd", "--csv", "-"];
    // Nobody reads the rows: the run cannot end in order.
    let mut child = begun(&folder, &run, || folder.at(".a.vcd.unfinished").exists());
    sleep(Duration::from_millis(300));
    child.send("INT");
    sleep(Duration::from_millis(100));
    child.send("TERM");
    // Sooner than it would give up by itself, as by the first one.
    sleep(Duration::from_millis(200));
    assert_eq!(child.status().and_then(|status| status.signal()), Some(15));
    assert_eq!(folder.names(), ["y.v"]);
}

#[test]
fn what_is_ignored_from_the_start_stays_so() {
    let folder = Folder::new();
    let line =
        format!("trap '' HUP; exec {} run ./y.v --ticks {ENDLESS} --vcd a.vcd", env!("CARGO_BIN_EXE_stepwright"));
    let mut command = Command::new("sh");
    command.current_dir(folder.at("")).args(["-c", &line]);
    let mut child = Running::begun(&mut command, || folder.at(".a.vcd.unfinished").exists());
    child.send("HUP");
    sleep(Duration::from_millis(500));
    assert_eq!(child.status(), None, "as under nohup");
}

#[test]
fn an_export_that_is_interrupted_writes_nothing() {
    let folder = Folder::new();
    let export = ["export", "./y.v", "--ticks", ENDLESS, "--verilog", "out"];
    let child = begun(&folder, &export, || true);
    sleep(Duration::from_millis(1000));
    let (output, _) = child.ended("INT");
    assert_eq!(output.status.code(), Some(1), "{}", said(&output));
    assert_eq!(folder.names(), ["y.v"]);
}

#[test]
fn the_command_to_go_on_with_can_be_pasted_into_a_shell() {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;
    let folder = Folder::new();
    let out = OsStr::from_bytes(b"it's \xff $HOME.csv");
    let long = ["sweep", "./y.v", "--over", "go=0,1,0,1", "--ticks", "20000000", "--engine", "interpreter"];
    let mut child = Running::begun(folder.command(&long).arg("--out").arg(out), || folder.at("").join(out).exists());
    sleep(Duration::from_millis(300));
    assert_eq!(child.status(), None, "it is long enough");
    let (output, _) = child.ended("INT");
    let hint = output.stderr.split(|&byte| byte == b'\n').nth(2).expect("a command").to_owned();
    let resumed = Command::new("sh").arg("-c").arg(OsStr::from_bytes(&hint)).current_dir(folder.at("")).output();
    let resumed = resumed.expect("a shell");
    assert!(resumed.status.success(), "{}{}", said(&output), said(&resumed));
    let rows = fs::read_to_string(folder.at("").join(out)).expect("the file");
    assert_eq!(rows.lines().count(), 5);
}
