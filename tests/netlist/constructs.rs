//! Each construct of the subset.

use std::sync::Arc;

use stepwright::base::{Diagnostic, Report};
use stepwright::blocks::Direction;
use stepwright::netlist::{Library, Netlist, load};

use super::{codes, good, read_by, roots, values};

/// A module with the 8-bit input `a`, the 8-bit output `y`, and this inside.
fn routed(inside: &str) -> String {
    let text = format!("module t (input wire [7:0] a, input wire s, output wire [7:0] y); {inside} endmodule");
    roots(&good(&text), "y")
}

#[test]
fn assigns_route_slices_concatenations_replications_and_constants() {
    for (inside, expected) in [
        ("assign y = a;", "a[7:0]"),
        ("assign y = {a[3:0], a[7:4]};", "a[3:0] a[7:4]"),
        ("assign y = {2{a[3:0]}};", "a[3:0] a[3:0]"),
        ("assign y = {{4{a[7]}}, a[7 -: 4]};", "a[7] a[7] a[7] a[7] a[7:4]"),
        ("assign y = {a[2 +: 4], 4'b0110};", "a[5:2] 4'd6"),
        ("assign y = 8'hA5;", "8'd165"),
        ("assign y = {4'd9, 3'o5, s};", "7'd77 s[0]"),
        ("assign y[3:0] = a[7:4]; assign y[7:4] = a[3:0];", "a[3:0] a[7:4]"),
        ("assign {y[0], y[7:1]} = a;", "a[6:0] a[7]"),
        ("wire [7:0] x = a; assign y = x;", "a[7:0]"),
        ("wire [1:0] h = a[7:6], l = a[1:0]; assign y = {h, a[5:2], l};", "a[7:0]"),
        ("wire [11:4] x = a; assign y = {x[4], x[11:5]};", "a[0] a[7:1]"),
        ("localparam [7:0] K = 8'd3; assign y = K;", "8'd3"),
        ("localparam [7:0] K = 8'hF0; assign y = {K[7:4], K[0 +: 4]};", "8'd240"),
        ("assign y = s_8; ", ""),
    ] {
        if expected.is_empty() {
            assert_eq!(codes(&format!("module t (output wire [7:0] y); {inside} endmodule")), ["N010"]);
        } else {
            assert_eq!(routed(inside), expected, "{inside}");
        }
    }
}

#[test]
fn a_header_declares_parameters_ports_signs_and_several_names_at_once() {
    let netlist = good(
        "`timescale 1ns / 1ps
        `default_nettype none
        // A comment
        module t /* another */ #(parameter WIDTH = 12, parameter integer N = WIDTH / 4, HALF = N)
            (input wire clk, input wire signed [WIDTH-1:0] a, b, input c,
             (* fraction = N, keep = \"yes\" *) output wire signed [N:0] x, output wire y);
            (* other *) assign x = {c, a[2:0]};
            assign y = b[WIDTH - 1];
        endmodule
        `default_nettype wire",
    );
    let ports = netlist.nets.iter().map(|net| (net.name.as_str(), net.width, net.signed, net.fraction));
    let expected = [
        ("clk", 1, false, None),
        ("a", 12, true, None),
        ("b", 12, true, None),
        ("c", 1, false, None),
        ("x", 4, true, Some(3)),
        ("y", 1, false, None),
    ];
    assert_eq!(ports.collect::<Vec<_>>(), expected);
    assert_eq!(values(&netlist), [("WIDTH".into(), 12), ("N".into(), 3), ("HALF".into(), 3)]);
    let names = |ids: &[stepwright::netlist::NetId]| {
        ids.iter().map(|id| netlist.nets[id.index()].name.clone()).collect::<Vec<_>>()
    };
    assert_eq!(
        (names(&netlist.inputs), names(&netlist.outputs)),
        (vec!["a".into(), "b".into(), "c".into()], vec!["x".into(), "y".into()])
    );
    assert!(netlist.nets[0].is_clock && netlist.nets[0].port == Some(Direction::Input));
}

#[test]
fn gates_take_any_number_of_inputs_and_several_stand_in_one_statement() {
    let netlist = good(
        "module t (input wire [7:0] a, output wire x, y, z);
            or or_6 (x, a[0], a[1], a[2], a[3], a[4], a[5], a[6]);
            nand nand_1 (y, a[0], a[1]), nand_2 (n, a[2]);
            wire n_before; wire n;
            not (z, n);
            buf (n_before, a[7]);
        endmodule"
            .replace("wire n_before; wire n;", "")
            .replace("or or_6", "wire n; wire n_before; or or_6")
            .as_str(),
    );
    let cells: Vec<_> = netlist.cells.iter().map(|cell| (cell.name.as_str(), cell.inputs.len())).collect();
    assert_eq!(cells, [("or_6", 7), ("nand_1", 2), ("nand_2", 1), ("not_unnamed_1", 1), ("buf_unnamed_2", 1)]);
    assert_eq!(roots(&netlist, "z"), "not_unnamed_1[0]");
    assert_eq!(read_by(&netlist, "nand_1", 1), ["a[1:1]"]);
}

#[test]
fn blocks_are_placed_with_their_parameters_and_may_leave_outputs_open() {
    let netlist = good(
        "module t (input wire clk, input wire [3:0] a, output wire [3:0] q);
            localparam HALF = 2;
            register #(.WIDTH(2 * HALF)) register_2 (.clk(clk), .word({a[0], a[3:1]}), .enable(1'b1), .clear(1'b0), .q(q));
            register #(.WIDTH(4)) register_3 (.clk(clk), .word(q), .enable(a[0]), .clear(1'b0), .q());
            register #(.WIDTH(4)) register_4 (.clk(clk), .word(q), .enable(a[0]), .clear(1'b0));
        endmodule",
    );
    assert_eq!(read_by(&netlist, "register_2", 0), ["a[0:0]", "a[3:1]"]);
    assert_eq!(roots(&netlist, "q"), "register_2[3:0]");
    assert!(netlist.cells.iter().all(|cell| Arc::ptr_eq(&cell.body, &netlist.cells[0].body)), "one body serves all");
}

const NESTED: &str = "module t (input wire [3:0] a, output wire [3:0] y);
        first #(.W(4)) first_1 (.x(a), .y(y));
    endmodule
    module first #(parameter W = 2) (input wire [W-1:0] x, output wire [W-1:0] y);
        parameter STEP = 1;
        second #(.W(W)) low (.x(x), .y(y));
    endmodule
    module second #(parameter W = 1) (input wire [W-1:0] x, output wire [W-1:0] y);
        assign y = {x[0], x[W-1:1]};
    endmodule";

#[test]
fn modules_inside_modules_pass_bits_and_parameters_down_and_up() {
    let netlist = good(NESTED);
    assert_eq!(roots(&netlist, "y"), "a[0] a[3:1]");
    assert_eq!(roots(&netlist, "first_1.low.x"), "a[3:0]");
    let scopes: Vec<_> = netlist.scopes.iter().map(|scope| (&*scope.name, &*scope.module)).collect();
    assert_eq!(scopes, [("t", "t"), ("first_1", "first"), ("low", "second")]);
}

#[test]
fn a_generate_loop_makes_a_scope_of_each_turn_named_as_icarus_names_it() {
    let netlist = good(
        "module t #(parameter N = 3) (input wire [N-1:0] a, b, output wire [N-1:0] y);
            genvar i;
            genvar j;
            generate
                for (i = 0; i < N; i = i + 1) begin : lane
                    wire [1:0] both = {a[i], b[i]};
                    localparam TWICE = 2 * i;
                    and and_1 (y[i], both[1], both[0]);
                    for (j = i; j > 0; j = j - 1) begin : deep
                        wire x = a[i - j];
                    end
                end
            endgenerate
        endmodule",
    );
    assert_eq!(roots(&netlist, "lane[2].both"), "a[2] b[2]");
    assert_eq!(roots(&netlist, "lane[2].deep[2].x"), "a[0]");
    assert_eq!(roots(&netlist, "lane[2].deep[1].x"), "a[1]");
    assert_eq!(roots(&netlist, "y"), "and_1[0] and_1[0] and_1[0]");
    assert_eq!(netlist.path(netlist.cells[2].scope), ["t", "lane[2]"]);
    let lane = netlist.scopes.iter().find(|scope| scope.name == "lane[1]").expect("a scope");
    assert_eq!(&*lane.module, "t.lane");
}

#[test]
fn a_vector_whose_bits_follow_one_another_is_no_loop() {
    let ripple = good(
        "module t (input wire [3:0] a, input wire c, output wire [4:0] carry);
            assign carry[0] = c;
            genvar i;
            for (i = 0; i < 4; i = i + 1) begin : stage
                and and_1 (carry[i + 1], carry[i], a[i]);
            end
        endmodule",
    );
    assert_eq!(roots(&ripple, "carry"), "and_1[0] and_1[0] and_1[0] and_1[0] c[0]");
    let shifted = good("module t (input wire s, output wire [3:0] y); assign y = {y[2:0], s}; endmodule");
    assert_eq!(roots(&shifted, "y"), "s[0] s[0] s[0] s[0]");
}

#[test]
fn registers_break_loops() {
    good(
        "module t (input wire clk, output wire q);
            wire n;
            not not_1 (n, q);
            register #(.WIDTH(1)) register_1 (.clk(clk), .word(n), .enable(1'b1), .clear(1'b0), .q(q));
        endmodule",
    );
}

/// One module of its own file, and one whose file cannot be read.
struct Shelf;

impl Library for Shelf {
    fn find(&self, file: &str) -> Option<Result<(String, Arc<str>), Report>> {
        let text = "module inverter #(parameter N = 1) (input wire x, output wire y); not not_1 (y, x); endmodule";
        match file {
            "inverter.v" => Some(Ok(("shelf/inverter.v".to_owned(), Arc::from(text)))),
            "locked.v" => Some(Err(Diagnostic::new("C002", "cannot read shelf/locked.v: permission denied").into())),
            _ => None,
        }
    }
}

fn load_with(name: &str, text: &str, top: Option<&str>, parameters: &[(&str, i64)]) -> Result<Netlist, Report> {
    let parameters: Vec<_> = parameters.iter().map(|(name, value)| ((*name).to_owned(), *value)).collect();
    load(name, text, top, &Shelf, &parameters)
}

#[test]
fn modules_that_are_not_in_the_file_come_from_the_library() {
    let text = "module t (input wire a, output wire y); inverter inverter_1 (.x(a), .y(y)); endmodule";
    let netlist = load_with("t.v", text, None, &[]).unwrap_or_else(|report| panic!("{report}"));
    assert_eq!(roots(&netlist, "y"), "not_1[0]");
    assert_eq!(netlist.sources.place(netlist.cells[0].span), "shelf/inverter.v:1:71");
}

#[test]
fn a_module_whose_file_cannot_be_read_is_told_once_with_the_reason_and_where_it_is_wanted() {
    let text = "module t (input wire a, output wire y); wire n;
        locked first (.x(a), .y(n));
        locked second (.x(n), .y(y));
    endmodule";
    let report = load_with("t.v", text, None, &[]).expect_err("unreadable");
    assert_eq!(report.diagnostics.len(), 1, "{report}");
    let text = report.to_string();
    assert!(text.contains("error[N001]: cannot read shelf/locked.v: permission denied"), "{text}");
    assert!(text.contains("t.v:2:9"), "{text}");
}

#[test]
fn the_top_is_the_one_asked_for_or_named_as_the_file_or_used_by_none() {
    let text =
        "module a (output wire y); b b_1 (.y(y)); endmodule module b (output wire y); assign y = 1'b1; endmodule";
    let top = |name, top| load_with(name, text, top, &[]).map(|netlist| netlist.scopes[0].name.clone());
    assert_eq!(top("circuits/b.v", None).as_deref().ok(), Some("b"));
    assert_eq!(top("circuits/c.v", None).as_deref().ok(), Some("a"));
    assert_eq!(top("circuits/c.v", Some("b")).as_deref().ok(), Some("b"));
    assert_eq!(top("circuits/c.v", Some("d")).expect_err("no such module").diagnostics[0].code, "N027");
}

#[test]
fn parameters_from_outside_replace_defaults_and_unknown_ones_are_refused_with_the_nearest() {
    let text = "module t #(parameter WIDTH = 4) (input wire [WIDTH-1:0] a, output wire y);
        parameter DEPTH = 2 * WIDTH; assign y = a[WIDTH-1]; endmodule";
    let netlist = load_with("t.v", text, None, &[("WIDTH", 7)]).unwrap_or_else(|report| panic!("{report}"));
    assert_eq!(values(&netlist), [("WIDTH".into(), 7), ("DEPTH".into(), 14)]);
    let netlist = load_with("t.v", text, None, &[("DEPTH", 1)]).unwrap_or_else(|report| panic!("{report}"));
    assert_eq!(values(&netlist), [("WIDTH".into(), 4), ("DEPTH".into(), 1)]);
    let report = load_with("t.v", text, None, &[("WIDHT", 7)]).expect_err("no such parameter");
    assert_eq!(report.diagnostics[0].code, "N014");
    assert!(report.to_string().contains("did you mean `WIDTH`?"), "{report}");
}

#[test]
fn the_shipped_circuits_load() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("circuits/su1522157");
    for name in ["interpolator.v", "multiplexer_21.v"] {
        let text = std::fs::read_to_string(folder.join(name)).expect("text");
        load_with(name, &text, None, &[]).unwrap_or_else(|report| panic!("{report}"));
    }
}
