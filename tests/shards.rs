//! Sweeps in shards, and what joins them.

use std::fs;

use crate::support::SCENARIO;
use crate::support::program::{Folder, said};

/// 22 rows.
const FRAMES: [&str; 6] = ["sweep", "frames.toml", "--over", "major_32=0..=40:4", "--over", "minor_34=0,3"];

fn folder() -> Folder {
    let folder = Folder::new();
    folder.write("frames.toml", SCENARIO);
    folder
}

fn with<'a>(arguments: &[&'a str], more: &[&'a str]) -> Vec<&'a str> {
    [arguments, more].concat()
}

/// Runs shards of a sweep, into `0.csv` and so on.
fn run_shards(folder: &Folder, arguments: &[&str], of: u64, ending: &str) -> Vec<String> {
    let run = |index| {
        let name = format!("{index}.{ending}");
        folder.done(&with(arguments, &["--shard", &format!("{index}/{of}"), "--out", &name]));
        name
    };
    (0..of).map(run).collect()
}

fn merged<'a>(parts: &[&'a str], out: &'a str) -> Vec<&'a str> {
    [&["merge"][..], parts, &["--out", out]].concat()
}

#[test]
fn parts_in_any_order_are_joined_into_the_file_of_the_whole_sweep() {
    let parameters =
        ["sweep", "frames.toml", "--over", "p:DELAY_13=1..=3", "--over", "minor_34=0..=4", "-s", "major_32=9"];
    let measured = with(&parameters, &["--measure", "steps,end"]);
    for (arguments, ending) in [(&FRAMES[..], "csv"), (&FRAMES, "jsonl"), (&parameters, "csv"), (&measured, "jsonl")] {
        for of in [1, 3, 8, 30] {
            let folder = folder();
            let (whole, out) = (format!("whole.{ending}"), format!("out.{ending}"));
            folder.done(&with(arguments, &["--out", &whole]));
            let parts = run_shards(&folder, arguments, of, ending);
            let mut parts: Vec<_> = parts.iter().map(String::as_str).collect();
            parts.rotate_left(of as usize / 2);
            folder.done(&merged(&parts, &out));
            assert!(folder.read(&out) == folder.read(&whole), "{arguments:?} in {of}");
            assert_eq!(folder.read(&format!("{out}.sweep")), folder.read(&format!("{whole}.sweep")));
        }
    }
}

#[test]
fn the_commands_of_the_page_write_the_file_of_the_whole_sweep() {
    let page = include_str!("../docs/shards.md");
    let commands = page.split("```sh\n").nth(1).and_then(|rest| rest.split("```").next()).expect("a block");
    let folder = folder();
    for command in commands.lines() {
        folder.done(&command.split(' ').skip(1).collect::<Vec<_>>());
    }
    folder.done(&["sweep", "us3809868/fig14_scaling", "--over", "j=0..=99", "--out", "whole.csv"]);
    assert_eq!(folder.read("all.csv"), folder.read("whole.csv"));
}

#[test]
fn rows_of_a_csv_file_are_sharded_like_ranges() {
    let folder = folder();
    folder.write("in.csv", "major_32,minor_34\n9,1\n9,2\n10,1\n10,2\n11,1\n");
    let arguments = ["sweep", "frames.toml", "--from", "in.csv"];
    folder.done(&with(&arguments, &["--out", "whole.csv"]));
    let parts = run_shards(&folder, &arguments, 2, "csv");
    folder.done(&merged(&[&parts[1], &parts[0]], "out.csv"));
    assert_eq!(folder.read("out.csv"), folder.read("whole.csv"));
    let rows = |name| String::from_utf8(folder.read(name)).expect("text").lines().count() - 1;
    assert_eq!((rows("0.csv"), rows("1.csv")), (2, 3));
}

#[test]
fn a_part_cut_anywhere_is_refused_until_it_has_been_resumed() {
    let folder = folder();
    folder.done(&with(&FRAMES, &["--out", "whole.csv"]));
    let parts = run_shards(&folder, &FRAMES, 3, "csv");
    let parts: Vec<_> = parts.iter().map(String::as_str).collect();
    let part = folder.read("1.csv");
    for left in [0, 5, part.len() / 2, part.len() - 1] {
        folder.write("1.csv", &part[..left]);
        folder.refused(&merged(&parts, "out.csv"), &["C084", "1.csv", "--shard 1/3"]);
        folder.done(&with(&FRAMES, &["--shard", "1/3", "--out", "1.csv", "--resume"]));
        assert!(folder.read("1.csv") == part, "cut after {left} bytes");
    }
    folder.write("1.csv", [&part[..], b"1,2"].concat());
    folder.refused(&merged(&parts, "out.csv"), &["C084"]);
    folder.write("1.csv", &part);
    folder.done(&merged(&parts, "out.csv"));
    assert_eq!(folder.read("out.csv"), folder.read("whole.csv"));
}

#[test]
fn what_is_missing_is_told_so_that_just_that_is_run_again() {
    let folder = folder();
    run_shards(&folder, &FRAMES, 8, "csv");
    // 22 rows in 8 shards begin with rows 0, 2, 5, 8, 11, 13, 16, 19.
    let told = ["C086", "shards 0,3-4,7 of 8", "rows 0 to 1, 8 to 12, 19 to 21", "--array=0,3-4,7"];
    folder.refused(&merged(&["6.csv", "1.csv", "2.csv", "5.csv"], "out.csv"), &told);
    folder.done(&with(&FRAMES, &["--shard", "1/2", "--out", "half.csv"]));
    folder.refused(&merged(&["0.csv", "1.csv", "half.csv"], "out.csv"), &["C086", "rows 5 to 10 are missing"]);
    // Shards of another number fit where their rows do.
    folder.done(&merged(&["0.csv", "1.csv", "2.csv", "3.csv", "half.csv"], "out.csv"));
}

#[test]
fn parts_with_rows_in_common_are_refused() {
    let folder = folder();
    run_shards(&folder, &FRAMES, 2, "csv");
    folder.done(&with(&FRAMES, &["--shard", "0/3", "--out", "third.csv"]));
    folder.refused(&merged(&["0.csv", "1.csv", "third.csv"], "out.csv"), &["C085", "third.csv", "0.csv"]);
    folder.refused(&merged(&["0.csv", "1.csv", "1.csv"], "out.csv"), &["C085"]);
}

#[test]
fn parts_of_another_circuit_version_or_format_are_refused() {
    let folder = folder();
    run_shards(&folder, &FRAMES, 2, "csv");
    folder.done(&with(&FRAMES, &["-p", "WIDTH=13", "--shard", "1/2", "--out", "wide.csv"]));
    let told = ["C083", "parameters.WIDTH: 12 in 0.csv, 13 in wide.csv"];
    folder.refused(&merged(&["0.csv", "wide.csv"], "out.csv"), &told);
    let described = String::from_utf8(folder.read("1.csv.sweep")).expect("text");
    folder.write("1.csv.sweep", described.replace(env!("CARGO_PKG_VERSION"), "9.9.9"));
    folder.refused(&merged(&["0.csv", "1.csv"], "out.csv"), &["C083", "stepwright", "9.9.9"]);
    folder.write("1.csv.sweep", described.replace("\"index\": 1", "\"index\": 2"));
    folder.refused(&merged(&["0.csv", "1.csv"], "out.csv"), &["C083", "is no shard"]);
    folder.write("1.csv.sweep", described);
    folder.done(&with(&FRAMES, &["--out", "whole.csv"]));
    folder.refused(&merged(&["0.csv", "whole.csv"], "out.csv"), &["C083", "whole.csv is no shard"]);
    folder.refused(&merged(&["0.csv", "1.csv"], "out.jsonl"), &["C083", "format"]);
    folder.write("1.csv", String::from_utf8_lossy(&folder.read("1.csv")).replacen("busy", "bust", 1));
    folder.refused(&merged(&["0.csv", "1.csv"], "out.csv"), &["C083", "header"]);
    fs::remove_file(folder.at("1.csv.sweep")).expect("a file");
    folder.refused(&merged(&["0.csv", "1.csv"], "out.csv"), &["C066", "1.csv.sweep", "copy both"]);
}

#[test]
fn a_merge_does_not_go_into_one_of_its_parts() {
    let folder = folder();
    run_shards(&folder, &FRAMES, 2, "csv");
    folder.refused(&merged(&["0.csv", "1.csv"], "./1.csv"), &["C030"]);
}

#[test]
fn two_shards_do_not_go_into_one_file_one_after_the_other_either() {
    let folder = folder();
    run_shards(&folder, &FRAMES, 1, "csv");
    folder.done(&with(&FRAMES, &["--shard", "0/2", "--out", "part.csv"]));
    let told = ["C082", "part.csv holds shard 0/2"];
    folder.refused(&with(&FRAMES, &["--shard", "1/2", "--out", "part.csv"]), &told);
    folder.refused(&with(&FRAMES, &["--shard", "1/2", "--out", "part.csv", "--resume"]), &told);
    folder.done(&with(&FRAMES, &["--shard", "0/2", "--out", "part.csv"]));
    folder.refused(&with(&FRAMES, &["--shard", "0/2", "--out", "-"]), &["C082"]);
}

#[test]
fn rows_at_the_limit_are_told_of_all_parts_together() {
    let folder = folder();
    let limited = ["sweep", "frames.toml", "--over", "major_32=60,1,2,61", "--limit", "100"];
    for shard in ["0/2", "1/2"] {
        let output = folder.run(&with(&limited, &["--shard", shard, "--out", &format!("{}.csv", &shard[..1])]));
        assert_eq!(output.status.code(), Some(1));
    }
    let output = folder.run(&merged(&["0.csv", "1.csv"], "out.csv"));
    assert_eq!(output.status.code(), Some(1));
    assert!(said(&output).contains("2 of 4 rows reached the limit"), "{}", said(&output));
}

#[test]
fn what_is_no_shard_is_refused() {
    let folder = folder();
    for shard in ["8/8", "0/0", "-1/8", "1", "1/", "a/8", "1/8/9", "auto/0", "18446744073709551616/8"] {
        let shard = format!("--shard={shard}");
        let mut command = folder.command(&with(&FRAMES, &[&shard, "--out", "out.csv"]));
        let output = command.env("PARALLEL_SEQ", "1").output().expect("it runs");
        assert_eq!(output.status.code(), Some(2), "{shard}");
        assert!(said(&output).contains("C080") && said(&output).contains("help:"), "{shard}: {}", said(&output));
    }
    assert!(!folder.at("out.csv").exists());
    assert_eq!(folder.run(&with(&FRAMES, &["--shard", "0/2"])).status.code(), Some(2), "without --out");
}

/// Runs a shard as a scheduler does, and tells which one ran or what was said.
fn scheduled(shard: &str, variables: &[(&str, &str)]) -> String {
    let folder = folder();
    let mut command = folder.command(&with(&FRAMES, &["--shard", shard, "--out", "out.csv"]));
    let names = ["ID", "COUNT", "MIN", "MAX"].map(|name| format!("SLURM_ARRAY_TASK_{name}"));
    for name in names {
        command.env_remove(name);
    }
    command.env_remove("JOB_COMPLETION_INDEX").env_remove("PARALLEL_SEQ").envs(variables.iter().copied());
    let output = command.output().expect("it runs");
    if !output.status.success() {
        return said(&output);
    }
    let described: serde_json::Value = serde_json::from_slice(&folder.read("out.csv.sweep")).expect("JSON");
    format!("{}/{}", described["shard"]["index"], described["shard"]["of"])
}

#[test]
fn schedulers_tell_the_shard() {
    let slurm = |[id, count, min, max]: [&'static str; 4]| {
        let names = ["SLURM_ARRAY_TASK_ID", "SLURM_ARRAY_TASK_COUNT", "SLURM_ARRAY_TASK_MIN", "SLURM_ARRAY_TASK_MAX"];
        names.into_iter().zip([id, count, min, max]).collect::<Vec<_>>()
    };
    assert_eq!(scheduled("auto", &slurm(["3", "8", "0", "7"])), "3/8");
    assert_eq!(scheduled("auto", &slurm(["5", "4", "2", "5"])), "3/4", "an array may begin anywhere");
    // Tasks 3 and 6, submitted again.
    assert_eq!(scheduled("auto/8", &slurm(["6", "2", "3", "6"])), "6/8");
    assert_eq!(scheduled("auto/8", &[("JOB_COMPLETION_INDEX", "7")]), "7/8");
    assert_eq!(scheduled("auto/8", &[("PARALLEL_SEQ", "8")]), "7/8", "GNU parallel counts from 1");
    for (shard, variables, told) in [
        ("auto", slurm(["6", "2", "3", "6"]), "holes"),
        ("auto", slurm(["0", "4", "0", "6"]), "holes"),
        ("auto", vec![("JOB_COMPLETION_INDEX", "7")], "SLURM_ARRAY_TASK_ID is not set"),
        ("auto/8", vec![], "none of"),
        ("auto/8", vec![("JOB_COMPLETION_INDEX", "x")], "not a number"),
        ("auto/8", vec![("PARALLEL_SEQ", "0")], "counts from 1"),
        ("auto/8", vec![("PARALLEL_SEQ", "1"), ("JOB_COMPLETION_INDEX", "1")], "both"),
    ] {
        let said = scheduled(shard, &variables);
        assert!(said.contains("C081") && said.contains(told), "{shard} {variables:?}: {said}");
    }
    assert!(scheduled("auto/8", &[("SLURM_ARRAY_TASK_ID", "8")]).contains("C080"));
}
