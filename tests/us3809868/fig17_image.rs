//! The memory image of FIG. 17: a file of one's own, and what is told of one that is missing or wrong.

use stepwright::simulation::{Circuit, Session};
use stepwright::trace::Select;

use super::machine::Machine;

/// FIG. 17 with the image `name`, which is looked for in a folder that holds just the file `own.glyphs` with `text`.
fn session(name: &str, text: &str) -> (Session, tempfile::TempDir) {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("own.glyphs"), text).expect("a file");
    let circuit = Circuit::shipped("us3809868/fig17_characters").unwrap_or_else(|report| panic!("{report}"));
    // The number that Verilog makes of a string.
    let name = name.bytes().fold(0, |number, letter| number << 8 | i64::from(letter));
    (circuit.with_library(folder.path()).session().parameter("IMAGE", name), folder)
}

/// FIG. 17 with an image of one's own.
pub fn machine_with(image: &str) -> Machine {
    let (session, _folder) = session("own", image);
    Machine::new(&session.observe(Select::new::<&str>([]).expect("no globs")))
}

fn refusal(name: &str, text: &str) -> String {
    session(name, text).0.elaborate().map(drop).expect_err("refused").to_string()
}

#[test]
fn a_missing_file_and_a_name_that_is_none_are_told_with_the_place_that_wants_them() {
    let missing = refusal("nowhere", "");
    for part in
        ["error[N050]: there is no file `nowhere.glyphs` beside the circuit", "fig17_characters.v:", "table_500"]
    {
        assert!(missing.contains(part), "{missing}");
    }
    assert_eq!(missing.matches("error[").count(), 2, "once for 500, once for 502: {missing}");
    for name in ["../a", "a b", "a.b"] {
        let wrong = refusal(name, "");
        assert!(wrong.contains("which is no name of a file"), "{wrong}");
    }
}

#[test]
fn all_mistakes_of_a_file_are_told_at_once_each_with_file_line_and_column() {
    let text = "glyph 41 A\n  move 0 O\n  advance 5\nglyph 41 B\n  arc 1 2 3\n";
    let told = refusal("own", text);
    for place in ["own.glyphs:2:10", "own.glyphs:4:7", "own.glyphs:5:3", "own.glyphs:4:1"] {
        assert!(told.contains(place), "{place}: {told}");
    }
    assert_eq!(told.matches("error[").count(), 4, "though two blocks read the file: {told}");
}

#[test]
fn a_file_without_end_is_refused_before_it_is_read() {
    let told = refusal("own", &"// long\n".repeat(600_000));
    assert!(told.contains("has 4800000 bytes; at most 4194304 are read"), "{told}");
}

#[test]
fn an_image_of_ones_own_is_drawn() {
    let mut machine = machine_with("glyph 2A box\n move 1 2\n line 5 2\n line 5 9\n advance 7\n");
    machine.set(&[("start", 1), ("code_449", 0x2A), ("scale_514", 4096), ("x0", 100)]);
    machine.tick();
    machine.set(&[("start", 0)]);
    let mut marked = Vec::new();
    while machine.get("done") == 0 {
        if machine.get("mark") == 1 {
            marked.push(["x", "y"].map(|name| machine.get_signed(name)));
        }
        machine.tick();
    }
    marked.dedup();
    let along: Vec<_> = (101..=105).map(|x| [x, 2]).chain((3..=9).map(|y| [105, y])).collect();
    assert_eq!(marked, along);
    assert_eq!([machine.get_signed("x"), machine.get_signed("y")], [107, 0]);
}

#[test]
fn the_command_line_and_a_scenario_name_the_image_as_a_string() {
    let folder = tempfile::tempdir().expect("a folder");
    let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).expect("a file");
    let circuit = stepwright::simulation::shipped::text("us3809868/fig17_characters.v").expect("shipped");
    write("fig17_characters.v", circuit);
    write("own.glyphs", "glyph 2A dot\n advance 7\n");
    write("dot.toml", "circuit = \"fig17_characters.v\"\n[parameters]\nIMAGE = \"own\"\n");
    let inputs = ["-s", "start=1", "-s", "code_449=0x2A", "-s", "scale_514=1.0", "--until", "done", "--json"];
    for target in [&["fig17_characters.v", "-p", "IMAGE=\"own\""][..], &["./dot.toml"]] {
        let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_stepwright"));
        let output = command.current_dir(folder.path()).arg("run").args(target).args(inputs).output().expect("it runs");
        let json = String::from_utf8_lossy(&output.stdout).into_owned();
        assert!(json.contains("\"x\":7"), "{target:?}: {json} {}", String::from_utf8_lossy(&output.stderr));
    }
}

/// Many tables of one image.
const MANY: &str = "
module many (input wire [7:0] code, output wire known);
    genvar i;
    for (i = 0; i < 20000; i = i + 1) begin : tables
        pointer_table #(.IMAGE(\"own\")) table_500 (.code(code), .pointer(), .known());
    end
    assign known = code[0];
endmodule
";

#[test]
fn thousands_of_instances_share_one_image() {
    let (_, folder) = session("own", &format!("glyph 2A x\n{} advance 7\n", "move 0 0\n".repeat(10_000)));
    let circuit = Circuit::text("many.v", MANY).with_library(folder.path());
    let design = circuit.session().elaborate().unwrap_or_else(|report| panic!("{report}"));
    let cells = &design.netlist().cells;
    assert_eq!(cells.len(), 20_000);
    assert!(cells.iter().all(|cell| std::sync::Arc::ptr_eq(&cell.body, &cells[0].body)));
}
