//! Texts that are too large or too deep for a careless reader.

use super::{codes, good, roots};
use crate::support::load_text;

fn module(inside: &str) -> String {
    format!("module t (input wire a, output wire y); {inside} endmodule")
}

#[test]
fn fifty_million_brackets_are_an_error_and_nothing_worse() {
    for (bracket, count) in [("(", 50_000_000), ("{", 1_000_000), ("[", 1_000_000), (")", 1_000_000)] {
        let report = load_text(&bracket.repeat(count)).expect_err("no circuit");
        assert_eq!(report.diagnostics.len(), 1);
        assert_eq!(report.diagnostics[0].code, "N003");
        assert!(report.render(false).len() < 1000, "a message is short, however long the line");
    }
    assert_eq!(codes(&module(&format!("assign y = {}a;", "(".repeat(1_000_000)))), ["N006"]);
}

#[test]
fn a_text_beyond_the_limit_is_refused_by_its_size() {
    let text = " ".repeat((64 << 20) + 1);
    assert!(load_text(&text).expect_err("too large").to_string().contains("67108865 bytes"));
}

#[test]
fn a_chain_of_a_hundred_thousand_assigns_is_followed_to_its_root() {
    let mut text = String::from("module t (input wire a, output wire y);\n");
    for i in (0..100_000).rev() {
        text += &format!("wire n{i};\n");
    }
    text += "assign n0 = a;\n";
    for i in 1..100_000 {
        text += &format!("assign n{i} = n{};\n", i - 1);
    }
    text += "assign y = n99999;\nendmodule\n";
    let netlist = good(&text);
    assert_eq!(roots(&netlist, "y"), "a[0]");
    let program = stepwright::compile::compile(&netlist, &stepwright::compile::Observe::EVERYTHING);
    assert_eq!(program.signals.len(), 100_002);
}

#[test]
fn a_chain_of_a_hundred_thousand_gates_loads_and_closed_is_a_loop() {
    let gates = |first: &str| {
        let mut text = format!("module t (input wire a, output wire y);\nwire n0;\nassign n0 = {first};\n");
        for i in 1..=100_000 {
            text += &format!("wire n{i};\n");
        }
        for i in 1..=100_000 {
            text += &format!("not g{i} (n{i}, n{});\n", i - 1);
        }
        text + "assign y = n100000;\nendmodule\n"
    };
    assert_eq!(roots(&good(&gates("a")), "y"), "g100000[0]");
    let report = load_text(&gates("y")).expect_err("a loop");
    assert_eq!(report.diagnostics.len(), 1);
    assert!(report.to_string().contains("a combinational loop through 100000 cells"));
    assert!(report.to_string().contains("and 99960 hops more"));
}

#[test]
fn operators_without_end_are_an_error_on_every_way_to_nest_them() {
    let deep = 200_000;
    for text in [
        format!("{}1", "~".repeat(deep)),
        format!("{}1{}", "(".repeat(deep), ")".repeat(deep)),
        format!("{}1'b1{}", "{".repeat(deep), "}".repeat(deep)),
        format!("1{}", "+1".repeat(deep)),
        format!("1{}", "?1:1".repeat(deep)),
        format!("{}1{}", "a[".repeat(deep), "]".repeat(deep)),
        format!("{}1{}", "$clog2(".repeat(deep), ")".repeat(deep)),
    ] {
        let found = codes(&module(&format!("localparam P = {text}; assign y = a;")));
        assert_eq!(found[0], "N006", "{}", &text[..20]);
    }
}

#[test]
fn loops_and_instances_that_would_fill_the_memory_are_refused() {
    let all = "genvar i; genvar j; for (i = 0; i < 65536; i = i + 1) begin : b
        for (j = 0; j < 65536; j = j + 1) begin : c wire x; end end assign y = a;";
    assert_eq!(codes(&module(all)), ["N033"]);
    assert_eq!(codes(&module("wire x = {2000000000{a}}; assign y = a;")), ["N006"]);
    // Each level doubles: 2^40 instances of a handful of templates.
    let mut text = String::new();
    for i in 0..40 {
        let inner = i + 1;
        text += &format!(
            "module m{i} (input wire a, output wire y); wire n; m{inner} x (.a(a), .y(n)); m{inner} z (.a(n), .y(y)); endmodule\n"
        );
    }
    text += "module m40 (input wire a, output wire y); assign y = a; endmodule\n";
    let report = load_text(&text).expect_err("too large");
    assert!(report.to_string().contains("parts; at most 1000000 are possible"), "{report}");
}

#[test]
fn hierarchies_deeper_than_any_machine_are_refused() {
    let mut text = String::new();
    for i in 0..20_000 {
        text += &format!("module m{i} (input wire a, output wire y); m{} x (.a(a), .y(y)); endmodule\n", i + 1);
    }
    text += "module m20000 (input wire a, output wire y); assign y = a; endmodule\n";
    assert!(load_text(&text).expect_err("too deep").to_string().contains("at most 64 levels"));
}

#[test]
fn loops_inside_one_another_have_a_limit() {
    let open: String =
        (0..50).map(|i| format!("genvar g{i}; for (g{i} = 0; g{i} < 1; g{i} = g{i} + 1) begin : b{i} ")).collect();
    let text = module(&format!("{open} {} assign y = a;", "end ".repeat(50)));
    assert_eq!(codes(&text), ["N006"]);
}

#[test]
fn a_thousand_errors_are_cut_short() {
    let text = module(&"assign q = r;\n".repeat(10_000));
    let report = load_text(&text).expect_err("errors");
    assert!(report.to_string().contains("more than 60 errors"));
    assert!(report.diagnostics.len() <= 61);
}

/// Runs a circuit with so many kibibytes of address space.
#[cfg(target_os = "linux")]
fn run_within(kibibytes: u64, text: &str) -> std::process::Output {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("circuit.v");
    std::fs::write(&path, text).expect("a file");
    let shell = format!("ulimit -v {kibibytes}; exec \"$0\" run \"$1\" --ticks 5");
    let mut command = std::process::Command::new("sh");
    command.args(["-c", &shell, env!("CARGO_BIN_EXE_stepwright")]).arg(path);
    command.output().expect("a shell")
}

/// 1000 parameters, and 4000 turns of a loop that could see them, in 22 KB. With a copy of the parameters for each turn it
/// took 597 MB.
#[cfg(target_os = "linux")]
#[test]
fn turns_of_a_loop_share_the_parameters_around_them() {
    let parameters: Vec<_> = (0..1000).map(|i| format!("parameter P{i} = {i}")).collect();
    let text = format!(
        "module circuit #({}) (input wire a, output wire y); assign y = a; genvar i;
            for (i = 0; i < 4000; i = i + 1) begin : turn wire x = a; end endmodule",
        parameters.join(", ")
    );
    let output = run_within(100_000, &text);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}

/// 60,000 blocks of several hundred ops, and 60,000 tables of 4096 words, which stand in memory once.
#[cfg(target_os = "linux")]
#[test]
fn what_blocks_expand_to_is_charged_and_equal_tables_are_shared() {
    let circuit = |block: &str| {
        format!(
            "module circuit (input wire clk, input wire [11:0] a, output wire y); assign y = a[0]; genvar i;
                for (i = 0; i < 60000; i = i + 1) begin : turn {block} end endmodule"
        )
    };
    let large = circuit("pulse_distributor #(.TAPS(64)) many (.clk(clk), .pulse_in(a[0]));");
    let output = run_within(200_000, &large);
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&output.stderr).contains("N035"));
    let tables = circuit("rom #(.ADDRESS(12)) table_1 (.address(a));");
    let output = run_within(400_000, &tables);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}
