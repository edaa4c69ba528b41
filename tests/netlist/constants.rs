//! Constant expressions, against the values that Icarus Verilog 12 gives them.

use super::values;
use crate::support::load_text;

/// Expression and value, as printed by `iverilog -g2005` for a localparam of that value.
const VALUES: &[(&str, i64)] = &[
    ("3 + 4 * 5", 23),
    ("(3 + 4) * 5", 35),
    ("2 ** 10", 1024),
    ("2 ** 3 ** 2", 64),
    ("7 / 2", 3),
    ("-7 / 2", -3),
    ("-7 % 3", -1),
    ("7 % -3", 1),
    ("10 - 4 - 3", 3),
    ("1 << 4", 16),
    ("256 >> 3", 32),
    ("-16 >>> 2", -4),
    ("4'sb1000 >>> 1", -4),
    ("4'b1000 >> 1", 4),
    ("4'd15 + 1", 16),
    ("~4'd3", 12),
    ("~3", -4),
    ("!3", 0),
    ("!0", 1),
    ("-4'd1", 15),
    ("&4'b1111", 1),
    ("&4'b1101", 0),
    ("|4'b0000", 0),
    ("^4'b0111", 1),
    ("~&4'b1111", 0),
    ("~|4'b0000", 1),
    ("~^4'b0111", 0),
    ("5 > 3", 1),
    ("-1 < 0", 1),
    ("4'd15 < -1", 1),
    ("3 <= 3", 1),
    ("3 >= 4", 0),
    ("3 == 3", 1),
    ("3 != 3", 0),
    ("3 === 3", 1),
    ("3 !== 4", 1),
    ("4'b1100 & 4'b1010", 8),
    ("4'b1100 | 4'b1010", 14),
    ("4'b1100 ^ 4'b1010", 6),
    ("4'b1100 ~^ 4'b1010", 9),
    ("1 && 0", 0),
    ("1 || 0", 1),
    ("2 && 4", 1),
    ("1 ? 10 : 20", 10),
    ("0 ? 10 : 20", 20),
    ("1 ? 0 ? 1 : 2 : 3", 2),
    ("{2'b10, 2'b01}", 9),
    ("{3{2'b10}}", 42),
    ("{2{4'hA}} + 1", 171),
    ("$clog2(1)", 0),
    ("$clog2(12)", 4),
    ("$clog2(4096)", 12),
    ("12'o17", 15),
    ("16'hBe_eF", 48879),
    ("4'sd7", 7),
    ("4'sb1111", -1),
    ("'d9", 9),
    ("'hFF", 255),
    ("1_000", 1000),
    ("8'sd255 + 0", -1),
    ("{4'sb1111} + 0", 15),
    ("4'sb1111 + 8'sd1", 0),
    ("4'sb1111 + 8'd1", 16),
    ("(4'd1 << 4) + 8'd0", 16),
    ("5 & 3 == 3", 1),
    ("1 | 2 ^ 3 & 6", 1),
    ("1 + 2 << 3", 24),
    ("64'd1 << 40", 1099511627776),
    ("4'd2 ** 3", 8),
    ("-2 ** 3", -8),
    ("(-1) ** 3", -1),
    ("2 ** -1", 0),
    ("0 ** 0", 1),
    ("16'd200 * 8'd2", 400),
    ("1 < 2 == 1", 1),
    ("+5", 5),
];

fn value_of(expression: &str) -> Option<i64> {
    let text = format!("module t #(parameter P = {expression}) (output wire y); assign y = 1'b0; endmodule");
    load_text(&text).ok().map(|netlist| netlist.parameters[0].value)
}

#[test]
fn constant_expressions_have_the_values_that_icarus_gives_them() {
    let wrong: Vec<_> = VALUES.iter().filter(|(text, value)| value_of(text) != Some(*value)).collect();
    assert!(wrong.is_empty(), "{wrong:?}");
}

#[test]
fn a_result_beyond_its_bits_is_refused_because_tools_disagree_on_it() {
    // IEEE 1364-2005 cuts the first to 0; Icarus lets it grow to 256.
    for text in ["8'hFF + 8'h01", "8'd3 - 8'd5", "1 << 31", "2 ** 31", "65536 * 65536", "64'd1 << 64", "3 ** 1000000"] {
        assert_eq!(value_of(text), None, "{text}");
    }
}

#[test]
fn a_declared_range_gives_its_width_to_the_whole_expression() {
    let text = "module t #(parameter [47:0] P = 1 << 40, parameter signed [7:0] N = -1, parameter integer I = 7)
        (output wire y); assign y = P[40]; endmodule";
    let netlist = load_text(text).unwrap_or_else(|report| panic!("{report}"));
    assert_eq!(values(&netlist), [("P".into(), 1 << 40), ("N".into(), -1), ("I".into(), 7)]);
}

#[test]
fn a_sign_without_a_range_takes_the_width_of_the_value_and_its_bits_as_signed() {
    // IEEE 1364-2005, 12.2.1.
    let text = "module t #(parameter signed P = 4'd8, parameter signed Q = 8'd200, parameter signed R = 8'd100)
        (output wire [7:0] y); localparam signed L = 4'd8; assign y = {P, L}; wire below = P + L < 0; endmodule";
    let netlist = load_text(text).unwrap_or_else(|report| panic!("{report}"));
    assert_eq!(values(&netlist), [("P".into(), -8), ("Q".into(), -56), ("R".into(), 100)]);
}

#[test]
fn nested_counts_and_bounds_take_no_time_in_their_depth() {
    // Worked out twice on each level, 60 levels would never end.
    let count = (0..60).fold("1'b1".to_owned(), |inner, _| format!("{{{inner}{{1'b1}}}}"));
    assert_eq!(value_of(&count), Some(1));
    let text = (0..60).fold("0".to_owned(), |inner, _| format!("Q[{inner}:0]"));
    let text =
        format!("module t #(parameter [0:0] Q = 0, parameter P = {text}) (output wire y); assign y = 1'b0; endmodule");
    assert!(load_text(&text).is_ok());
}
