//! `diff` on files of any tools, with all that can be chosen.

use std::path::Path;

use serde_json::{Value, json};

use super::{ROOT, folder, stderr, stdout, stepwright_in, written};

/// A file with a clock of 10 ns, a word and a bit below some scopes; one line of values for each rising edge.
fn clocked(scopes: &[&str], words: &[u64]) -> String {
    let open: String = scopes.iter().map(|scope| format!("$scope module {scope} $end\n")).collect();
    let close = "$upscope $end\n".repeat(scopes.len());
    let vars = "$var wire 1 c clk $end\n$var wire 4 w word [3:0] $end\n";
    let mut text = format!("$timescale 1 ns $end\n{open}{vars}{close}$enddefinitions $end\n");
    for (tick, word) in words.iter().enumerate() {
        text += &format!("#{}\n0c\nb{word:b} w\n#{}\n1c\n", 10 * tick, 10 * tick + 5);
    }
    text + &format!("#{}\n", 10 * words.len())
}

fn diff(folder: &Path, options: &[&str]) -> (Option<i32>, Value) {
    let output = stepwright_in(folder, &[&["diff", "a.vcd", "b.vcd", "--json"], options].concat());
    let object = serde_json::from_str(&stdout(&output)).unwrap_or_else(|_| panic!("{options:?}: {}", stderr(&output)));
    (output.status.code(), object)
}

#[test]
fn signals_of_other_scopes_are_compared_at_an_edge_and_the_samples_that_differ_are_counted() {
    let folder = folder();
    written(folder.path(), "a.vcd", clocked(&["top", "u1"], &[1, 2, 3, 4, 5]));
    written(folder.path(), "b.vcd", clocked(&["bench", "dut"], &[1, 2, 9, 4, 9]));
    let (status, found) = diff(folder.path(), &["--at", "clk"]);
    assert_eq!((status, &found["equal"]), (Some(1), &json!(false)));
    assert_eq!(found["first"], json!({ "tick": 2, "net": "top.u1.word", "a": 3, "b": 9 }));
    assert_eq!(found["differing"], json!({ "top.u1.word": 2 }));
    // Without an edge each lasts 10 ns.
    assert_eq!(diff(folder.path(), &[]).1["differing"], json!({ "top.u1.word": 20 }));
    assert_eq!(diff(folder.path(), &["--at", "!clk"]).1["first"]["tick"], json!(2));
    // 9 is 6 from 3 and 4 from 5.
    assert_eq!(diff(folder.path(), &["--at", "clk", "--near", "6"]).0, Some(0));
    assert_eq!(diff(folder.path(), &["--at", "clk", "--near", "5"]).1["differing"], json!({ "top.u1.word": 1 }));
    assert_eq!(diff(folder.path(), &["--at", "clk", "--late", "1"]).0, Some(0));
    assert_eq!(diff(folder.path(), &["--at", "clk", "--from", "3", "--to", "3"]).0, Some(0));
    assert_eq!(diff(folder.path(), &["--at", "clk", "--from", "3"]).1["first"]["tick"], json!(4));
}

#[test]
fn a_signal_that_only_one_file_has_is_told_and_is_no_difference_but_a_missing_end_is_one() {
    let folder = folder();
    let both = clocked(&["t"], &[1, 2, 3]);
    written(folder.path(), "a.vcd", &both);
    written(folder.path(), "b.vcd", both.replace(" word ", " other "));
    let (status, found) = diff(folder.path(), &[]);
    assert_eq!((status, &found["only_a"], &found["only_b"]), (Some(0), &json!(["t.word"]), &json!(["t.other"])));
    assert_eq!(diff(folder.path(), &["--map", "t.word=t.other"]).1["compared"], json!(2));
    written(folder.path(), "b.vcd", clocked(&["t"], &[1, 2]));
    assert_eq!(diff(folder.path(), &[]).0, Some(1));
    assert_eq!(diff(folder.path(), &["--to", "9"]).0, Some(0));
}

#[test]
fn files_without_a_common_signal_end_with_status_3() {
    let folder = folder();
    written(folder.path(), "a.vcd", clocked(&["t"], &[1]));
    written(folder.path(), "b.vcd", clocked(&["t"], &[1]).replace(" word ", " other ").replace(" clk ", " clock "));
    assert_eq!(diff(folder.path(), &[]).0, Some(3));
}

#[test]
fn unknown_bits_are_masked_as_asked() {
    let folder = folder();
    written(folder.path(), "a.vcd", clocked(&["t"], &[0, 4]));
    written(folder.path(), "b.vcd", clocked(&["t"], &[0, 4]).replace("b100 w", "b1x0 w"));
    let status = |mask: &[&str]| diff(folder.path(), mask).0;
    assert_eq!([status(&[]), status(&["--mask", "zero"]), status(&["--mask", "wild"])], [Some(1), Some(0), Some(0)]);
}

#[test]
fn with_a_circuit_the_net_that_went_wrong_first_is_named_with_its_block_and_what_follows() {
    let folder = folder();
    let run = |name: &str, minor: &str| {
        let output =
            stepwright_in(folder.path(), &["run", "su1522157/table1", "-s", minor, "--ticks", "40", "--vcd", name]);
        assert!(output.status.success(), "{}", stderr(&output));
    };
    run("a.vcd", "minor_34=3");
    run("b.vcd", "minor_34=4");
    let (status, found) = diff(folder.path(), &["--circuit", "su1522157/interpolator"]);
    assert_eq!(
        (status, &found["cause"]["net"], &found["cause"]["tick"]),
        (Some(1), &json!("interpolator.minor_34"), &json!(0))
    );
    assert_eq!(found["causes"].as_array().map(Vec::len), Some(1), "all comes from that input: {}", found["causes"]);
    let follows = found["cause"]["follows"].as_array().expect("a list");
    assert_eq!(follows.len() + 1, found["differing"].as_object().expect("nets").len() - aliases(&found));
}

/// How many of the nets that differ are another name of one.
fn aliases(found: &Value) -> usize {
    let told: Vec<_> =
        found["cause"]["follows"].as_array().expect("a list").iter().chain([&found["cause"]["net"]]).collect();
    found["differing"].as_object().expect("nets").keys().filter(|net| !told.contains(&&json!(net))).count()
}

#[test]
fn a_net_that_is_wrong_in_one_file_is_named_with_its_place_in_the_circuit() {
    let folder = folder();
    let golden = std::fs::read_to_string(format!("{ROOT}/traces/su1522157/table1.vcd")).expect("a file");
    written(folder.path(), "a.vcd", &golden);
    // Tap 23 rises one tick late, once: of all nets just this one is wrong, and nothing follows in a file.
    let line = golden.lines().find(|line| line.contains(" tap_23 ")).expect("a declaration");
    let rise = format!("\n1{}\n", line.split_whitespace().nth(3).expect("an identifier"));
    let at = golden.find(&rise).expect("it rises");
    let changed = format!("{}\n{}", &golden[..at], &golden[at + rise.len()..]);
    written(folder.path(), "b.vcd", changed);
    let output = stepwright_in(folder.path(), &["diff", "a.vcd", "b.vcd", "--circuit", "su1522157/table1"]);
    let text = stdout(&output);
    assert_eq!(output.status.code(), Some(1), "{text}");
    assert!(text.contains("interpolator.tap_23 first went wrong"), "{text}");
    assert!(text.contains("circuits/su1522157/interpolator.v:"), "its place is named: {text}");
}
